#include "search/solid_data.h"

namespace sectile {

const FaceTree& SolidData::tree() const {
  std::call_once(tree_once_, [this] { tree_ = std::make_unique<FaceTree>(brep, geometry); });
  return *tree_;
}

}  // namespace sectile
