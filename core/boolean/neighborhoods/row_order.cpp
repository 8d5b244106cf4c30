#include "boolean/neighborhoods/row_order.h"

#include <algorithm>
#include <tuple>

#include "boolean/line.h"
#include "geometry/around_line.h"
#include "sectile/errors.h"

namespace sectile {

RowOrder::RowOrder(const Workspace& w, const Contacts& contacts, const Row& row)
    : w_(w), row_(row) {
  const Row::Run& any = row.runs.front();
  const auto [a, b] = line_planes(w.patch[any.operand], Brep::half_edge(any.edge));
  const int axis = w.tests().cross_axis(a, b);
  const Sign up = w.tests().compare(contacts.point(row.places.front()),
                                    contacts.point(row.places.back()), axis);
  find_faces(axis, up);
  sort(axis, up);
}

PlaneId RowOrder::plane(RowSide side) const {
  return w_.patch[row_.runs[side / 2].operand].plane(face_[side]);
}

void RowOrder::find_faces(int axis, Sign up) {
  for (const Row::Run& run : row_.runs) {
    const Patch& patch = w_.patch[run.operand];
    const HalfEdgeId h = Brep::half_edge(run.edge);
    const bool along = w_.tests().compare(patch.brep.point_of(patch.brep.from(h)),
                                          patch.brep.point_of(patch.brep.to(h)), axis) == up;
    along_.push_back(along ? 1 : 0);
    for (const bool forward : {true, false}) {
      const FaceId face = patch.brep.face_of(Brep::half_edge(run.edge, forward == along ? 0 : 1));
      if (!patch.is_real(face))
        throw InternalError("a face that meets the other boundary was not loaded");
      face_.push_back(face);
    }
  }
}

void RowOrder::sort(int axis, Sign up) {
  const AroundLine line(w_.tests(), axis, up);
  struct Around {
    int quarter;
    LineSide half_plane;
    RowSide side;
  };
  std::vector<Around> all;
  const LineSide start{plane(0), true};
  for (RowSide side = 0; side < face_.size(); ++side) {
    const LineSide half_plane{plane(side), is_forward(side)};
    all.push_back({line.quarter(start, half_plane), half_plane, side});
  }
  std::ranges::sort(all, [&](const Around& p, const Around& q) {
    if (p.quarter != q.quarter) return p.quarter < q.quarter;
    const Sign sign = line.turn(p.half_plane, q.half_plane);
    return sign != Sign::zero ? sign == Sign::positive : p.side < q.side;
  });
  position_.resize(all.size());
  first_.resize(all.size());
  behind_.resize(all.size());
  for (std::uint32_t i = 0; i < all.size(); ++i) {
    side_at_.push_back(all[i].side);
    position_[all[i].side] = i;
    const bool same = i > 0 && all[i].quarter == all[i - 1].quarter &&
                      line.tied(all[i].half_plane, all[i - 1].half_plane);
    first_[i] = same ? first_[i - 1] : i;
  }
  for (std::uint32_t i = static_cast<std::uint32_t>(all.size()); i-- > 0;)
    behind_[i] = i + 1 < all.size() && first_[i + 1] == first_[i] ? behind_[i + 1] : i + 1;
}

}  // namespace sectile
