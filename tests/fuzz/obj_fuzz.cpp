#include "fuzz/read_anything.h"

using namespace sectile;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::read_anything(data, size, read_obj, [](const PolygonMesh& mesh) {
    fuzz::require_same(mesh,
                       read_obj(fuzz::written([&](Sink& out) { write_obj(out, mesh); }), "again"));
  });
}
