#include "search/solid_data.h"

namespace sectile {

const FaceTree& SolidData::tree() const {
  std::call_once(tree_once_, [this] { tree_ = std::make_unique<FaceTree>(brep_, geometry_); });
  return *tree_;
}

bool SolidData::touches_itself() const {
  std::call_once(touches_once_, [this] {
    std::vector<bool> seen(geometry_.positions.size());
    for (const PointId p : brep_.point) {
      if (seen[p.value()]) touches_itself_ = true;
      seen[p.value()] = true;
    }
  });
  return touches_itself_;
}

}  // namespace sectile
