#include "boolean/neighborhoods/row_order.h"

#include <algorithm>
#include <tuple>

#include "boolean/line.h"
#include "geometry/around_line.h"
#include "sectile/errors.h"

namespace sectile {

RowOrder::RowOrder(const Workspace& w, const Contacts& contacts, const Row& row)
    : w_(w), row_(row) {
  const auto edge =
      std::ranges::find_if(row.runs, [](const Row::Run& run) { return run.carrier.is_edge(); });
  std::tie(line_[0], line_[1]) =
      line_planes(w.patch[edge->operand], Brep::half_edge(edge->carrier.edge()));
  axis_ = w.tests().cross_axis(line_[0], line_[1]);
  up_ = w.tests().compare(contacts.point(row.places.front()), contacts.point(row.places.back()),
                          axis_);
  find_faces();
  sort();
}

PlaneId RowOrder::plane(RowSide side) const {
  return w_.patch[row_.runs[side / 2].operand].plane(face_[side]);
}

Direction RowOrder::direction(PlaneId plane) const {
  const AroundLine line(w_.tests(), axis_, up_);
  const Sign sense = line.cross(plane, line_[0]);
  return sense != Sign::zero ? Direction{line_[0], sense}
                             : Direction{line_[1], line.cross(plane, line_[1])};
}

void RowOrder::find_faces() {
  for (const Row::Run& run : row_.runs) {
    const Patch& patch = w_.patch[run.operand];
    const bool along = run.carrier.is_face() || runs_along(run);
    along_.push_back(along ? 1 : 0);
    for (const bool forward : {true, false}) {
      const FaceId face =
          run.carrier.is_face()
              ? run.carrier.face()
              : patch.brep.face_of(Brep::half_edge(run.carrier.edge(), forward == along ? 0 : 1));
      if (!patch.is_real(face))
        throw InternalError("a face that meets the other boundary was not loaded");
      face_.push_back(face);
    }
  }
}

// Of an edge.
bool RowOrder::runs_along(const Row::Run& run) const {
  const Brep& brep = w_.patch[run.operand].brep;
  const HalfEdgeId h = Brep::half_edge(run.carrier.edge());
  return w_.tests().compare(brep.point_of(brep.from(h)), brep.point_of(brep.to(h)), axis_) == up_;
}

void RowOrder::sort() {
  const AroundLine line(w_.tests(), axis_, up_);
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
