#include "boolean/reduction/face_stretches.h"

#include <algorithm>
#include <span>

#include "boolean/line.h"
#include "boolean/reduction/standing.h"
#include "geometry/probe.h"

namespace sectile {
namespace {

class StretchesFinder {
 public:
  StretchesFinder(Workspace& w, Operand s, FaceId face, PlaneId across,
                  const AlongLineOfPoints& along)
      : w_(w), patch_(w.patch[s]), s_(s), face_(face), across_(across), along_(along) {}

  std::vector<FaceStretch> stretches() {
    std::vector<FaceStretch> found;
    find_sides();
    find_items();
    for (std::size_t from = 0, to, end; from < items_.size(); from = to) {
      to = behind(from);
      if (to == items_.size()) break;
      end = behind(to);
      add_between({items_.begin() + from, items_.begin() + to},
                  {items_.begin() + to, items_.begin() + end}, found);
    }
    return found;
  }

 private:
  struct Item {
    PointId point;
    BoundaryItem of;
  };

  // Of the start of each half-edge.
  void find_sides() {
    for_each_in_face(patch_.brep, face_, [&](HalfEdgeId h) {
      sides_.push_back({h, w_.tests().side(patch_.brep.point_of(patch_.brep.from(h)), across_)});
    });
  }

  void find_items() {
    for (std::size_t i = 0, first = 0; i < sides_.size(); ++i) {
      const HalfEdgeId h = sides_[i].h;
      const bool closes =
          i + 1 == sides_.size() || patch_.brep.loop_of(h) != patch_.brep.loop_of(sides_[i + 1].h);
      const Sign to = closes ? sides_[first].side : sides_[i + 1].side;
      if (closes) first = i + 1;
      if (sides_[i].side == Sign::zero)
        items_.push_back({patch_.brep.point_of(patch_.brep.from(h)), {patch_.brep.from(h), h}});
      else if (sides_[i].side * to == Sign::negative)
        items_.push_back({crossing(h), {Brep::edge_of(h), h}});
    }
    w_.kernel->refresh();
    std::ranges::sort(items_, [&](const Item& p, const Item& q) {
      const Sign sign = along_.compare(p.point, q.point);
      return sign != Sign::zero ? sign == Sign::positive : p.of < q.of;
    });
  }

  PointId crossing(HalfEdgeId h) {
    const Construction how = edge_plane_construction(w_, s_, h, across_);
    return add_constructed(w_.geometry, how, w_.tests().construct(how));
  }

  std::size_t behind(std::size_t first) const {
    std::size_t end = first + 1;
    while (end < items_.size() &&
           along_.compare(items_[first].point, items_[end].point) == Sign::zero)
      ++end;
    return end;
  }

  void add_between(std::span<const Item> from, std::span<const Item> to,
                   std::vector<FaceStretch>& found) {
    const Kernel& kernel = w_.tests();
    const PointId p = from.front().point, q = to.front().point;
    const Direction d = direction_between(kernel, patch_.plane(face_), across_, p, q);
    const Standing first = stands(from, d);
    if (first.where != Standing::Where::inside) return;
    found.push_back({{{p, first.entity}, {q, stands(to, -d).entity}}});
  }

  Standing stands(std::span<const Item> at, const Direction& d) {
    bounds_.clear();
    for (const Item& item : at) bounds_.push_back(item.of);
    return standing(w_.tests(), patch_, face_, bounds_, d);
  }

  struct Side {
    HalfEdgeId h;
    Sign side;
  };

  Workspace& w_;
  const Patch& patch_;
  Operand s_;
  FaceId face_;
  PlaneId across_;
  const AlongLineOfPoints& along_;
  std::vector<Side> sides_;  // loop by loop
  std::vector<Item> items_;
  std::vector<BoundaryItem> bounds_;
};

}  // namespace

std::vector<FaceStretch> face_stretches(Workspace& w, Operand s, FaceId face, PlaneId across,
                                        const AlongLineOfPoints& along) {
  return StretchesFinder(w, s, face, across, along).stretches();
}

}  // namespace sectile
