#include "boolean/check_links.h"

#include "topology/links.h"

namespace sectile {

void check_links(const Workspace& w, const char* after) {
  if (!w.options.validate) return;
  for (const Patch& patch : w.patch)
    if (const auto found = broken_links(patch.brep, patch.unbounded); !found.empty())
      throw InternalError(std::string("after ") + after + ": " + found.front());
}

}  // namespace sectile
