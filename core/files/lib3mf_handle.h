// Objects of lib3mf, which are released when they go out of scope.
#pragma once

#include <Model/COM/NMR_DLLInterfaces.h>

#include <memory>
#include <utility>

namespace sectile {

/// lib3mf's C interface has one pointer for everything.
using Lib3mfPointer = NMR::PLib3MFBase*;

struct ReleaseLib3mf {
  void operator()(Lib3mfPointer instance) const { NMR::lib3mf_release(instance); }
};
using Lib3mfHandle = std::unique_ptr<NMR::PLib3MFBase, ReleaseLib3mf>;

/// What the function puts behind its last argument; empty if it fails.
template <class Function, class... Arguments>
Lib3mfHandle lib3mf_handle(Function function, Arguments... arguments) {
  Lib3mfPointer pointer = nullptr;
  const bool done = function(arguments..., &pointer) == LIB3MF_OK;
  Lib3mfHandle handle(pointer);
  return done ? std::move(handle) : nullptr;
}

}  // namespace sectile
