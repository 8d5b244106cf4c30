#include "import/faces_along_x.h"

#include <algorithm>
#include <utility>

#include "numbers/threshold.h"
#include "search/face_tree.h"

namespace sectile {

Box StretchAlongX::box() const {
  Bounds bounds;
  bounds.add({begin, low_y, low_z});
  bounds.add({end, high_y, high_z});
  return bounds.box();
}

FacesAlongX::FacesAlongX(const SolidData& data, std::vector<FaceId> faces, std::size_t lines)
    : faces_(std::move(faces)) {
  const Brep& brep = data.brep();
  std::vector<Box> boxes;
  boxes.reserve(faces_.size());
  for (const FaceId f : faces_) boxes.push_back(face_box(brep, data.geometry(), f));
  tree_ = BoxTree(boxes);
  constexpr std::size_t many = threshold(16, 1);
  if (lines >= many && are_mostly_empty(boxes))
    oriented_.emplace(tree_, [&](std::uint32_t i, const auto& add) {
      for_each_in_loop(brep, brep.outer_loop[faces_[i]], [&](HalfEdgeId h) {
        add(data.geometry().position(brep.point_of(brep.from(h))));
      });
    });
}

bool FacesAlongX::Near::operator()(BoxTree::Node n) const {
  const Box& box = faces_.tree_.box(n);
  if (!stretch_.may_meet(box)) return false;
  if (!faces_.oriented_) return true;
  if (!oriented_ || end_ != stretch_.end) {
    StretchAlongX bounded = stretch_;
    bounded.end = std::min(bounded.end, double(faces_.tree_.bounds().high[0]));
    oriented_ = OrientedBox(bounded.box());
    end_ = stretch_.end;
  }
  return !apart((*faces_.oriented_)[n], *oriented_);
}

// About, which is enough for an order.
double FacesAlongX::begin_of(BoxTree::Node n, const StretchAlongX& stretch) const {
  if (!oriented_) return tree_.box(n).low[0];
  return begin_along_x((*oriented_)[n], {stretch.begin, stretch.low_y, stretch.low_z});
}

}  // namespace sectile
