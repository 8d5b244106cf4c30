// Which faces a line along the x axis may meet, the near ones first.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "search/box_tree.h"
#include "search/oriented_tree.h"
#include "storage/solid_data.h"

namespace sectile {

/// A part of a line along the x axis, for which there are bounds in doubles.
struct StretchAlongX {
  double begin = 0, end = 0;
  double low_y = 0, high_y = 0, low_z = 0, high_z = 0;

  bool may_meet(const Box& b) const {
    return b.low[1] <= high_y && low_y <= b.high[1] && b.low[2] <= high_z && low_z <= b.high[2] &&
           begin <= b.high[0] && b.low[0] <= end;
  }
  Box box() const;
};

class FacesAlongX {
 public:
  /// For about so many lines.
  FacesAlongX(const SolidData& data, std::vector<FaceId> faces, std::size_t lines);

  /// Calls visit(face) for all that the stretch meets and for few others. visit may make it
  /// shorter: as a rule, those near its beginning come first.
  template <class Visit>
  void query(const StretchAlongX& stretch, const Visit& visit) const {
    const Near near(*this, stretch);
    tree_.query_in_order(
        near,
        [&](BoxTree::Node n, BoxTree::Node m) {
          return begin_of(n, stretch) < begin_of(m, stretch);
        },
        [&](std::uint32_t item) { visit(faces_[item]); });
  }

 private:
  // Of nodes and of single faces: may the stretch, as it is now, meet them?
  class Near {
   public:
    Near(const FacesAlongX& faces, const StretchAlongX& stretch)
        : faces_(faces), stretch_(stretch) {}
    bool operator()(const Box& box) const { return stretch_.may_meet(box); }
    bool operator()(BoxTree::Node n) const;

   private:
    const FacesAlongX& faces_;
    const StretchAlongX& stretch_;
    mutable double end_ = 0;
    mutable std::optional<OrientedBox> oriented_;  // around the stretch up to this end
  };

  double begin_of(BoxTree::Node n, const StretchAlongX& stretch) const;

  std::vector<FaceId> faces_;
  BoxTree tree_;                          // over them
  std::optional<OrientedTree> oriented_;  // for many lines where boxes are mostly empty
};

}  // namespace sectile
