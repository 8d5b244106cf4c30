// The outline of a face of very many corners, through which lines along the x axis go.
#pragma once

#include <optional>
#include <vector>

#include "search/outline_tree.h"
#include "topology/brep.h"

namespace sectile {

class OutlineAcrossX {
 public:
  OutlineAcrossX(const Brep& brep, const Geometry& geometry, FaceId face);

  /// Around all corners.
  const Box& box() const { return tree_.as_target().box; }
  /// Does the line through a point go through the face? As goes_through(): nothing if that is not
  /// certain.
  std::optional<bool> is_met(const Vec3& p) const;

 private:
  struct Corners {
    std::vector<Vec3> at;
    std::vector<std::uint32_t> loop_ends, next;
    Corners(const Brep& brep, const Geometry& geometry, FaceId face);
  };

  Corners corners_;
  OutlineTree tree_;
};

}  // namespace sectile
