#include "boolean/neighborhoods/neighborhoods.h"

#include <algorithm>
#include <utility>

#include "boolean/line.h"
#include "geometry/around_line.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// Segments come in the order of their places, what meets in one in that of its entities.
struct Keyed {
  std::uint64_t places, entities;
  std::uint32_t record;
  friend auto operator<=>(const Keyed&, const Keyed&) = default;
};

LineSide line_side(const HalfPlane& h) {
  return {h.plane, h.forward};
}

class SegmentBuilder {
 public:
  SegmentBuilder(const Workspace& w, const Contacts& contacts, const Wanted& wanted)
      : w_(w),
        kernel_(w.tests()),
        contacts_(contacts),
        wanted_(wanted),
        line_(kernel_, -1, Sign::zero) {
    found_.wedges.resize(wanted.operations.size());
    for (const Operand s : both_operands) {
      last_with_face_[s].resize(w.patch[s].brep.face_count());
      last_with_edge_[s].resize(w.patch[s].brep.edge_count());
    }
  }

  void operator()(std::span<const Keyed> records) {
    segment_ = {};
    const SegmentRecord& any = contacts_.segments[records[0].record];
    segment_.place[0] = any.place[0];
    segment_.place[1] = any.place[1];
    add_carriers(records);
    add_half_planes();
    find_line();
    sort();
    classify();
    for (std::size_t i = 0; i < wanted_.operations.size(); ++i)
      pair_wedges(wanted_.operations[i], found_.wedges[i]);
    if (wanted_.operations.empty()) cut_between_classes();
    found_.segments.add(segment_);
  }

  Neighborhoods take() { return std::move(found_); }

 private:
  struct Sorted {
    int quarter;
    HalfPlane half_plane;
  };

  Carrier& carrier_of(const HalfPlane& h) { return found_.carriers[h.carrier]; }
  std::span<HalfPlane> half_planes() { return found_.half_planes[segment_.half_planes]; }

  void add_carriers(std::span<const Keyed> records) {
    const CarrierId first = found_.carriers.end_id();
    for (const Keyed& r : records)
      for (const Operand s : both_operands) add_carrier(s, contacts_.segments[r.record]);
    segment_.carriers = found_.carriers.ids_from(first);
  }

  void add_carrier(Operand s, const SegmentRecord& r) {
    const SegmentId here = found_.segments.end_id();
    SegmentId& last =
        r.on[s].is_edge() ? last_with_edge_[s][r.on[s].edge()] : last_with_face_[s][r.on[s].face()];
    if (std::exchange(last, here) == here) return;
    Carrier carrier{};
    carrier.operand = s;
    carrier.entity = r.on[s];
    carrier.end[0] = r.end[s][0];
    carrier.end[1] = r.end[s][1];
    if (carrier.entity.is_edge()) carrier.along = runs_along(s, carrier.entity.edge());
    found_.carriers.add(carrier);
  }

  bool runs_along(Operand s, EdgeId e) const {
    const Patch& patch = w_.patch[s];
    const HalfEdgeId h = Brep::half_edge(e);
    const auto [a, b] = line_planes(patch, h);
    const int axis = kernel_.cross_axis(a, b);
    return kernel_.compare(patch.brep.point_of(patch.brep.from(h)),
                           patch.brep.point_of(patch.brep.to(h)), axis) == sense(axis);
  }

  // The sign of the segment's direction on an axis.
  Sign sense(int axis) const {
    return kernel_.compare(contacts_.point(segment_.place[0]), contacts_.point(segment_.place[1]),
                           axis);
  }

  void add_half_planes() {
    const HalfPlaneId first = found_.half_planes.end_id();
    for (const CarrierId id : segment_.carriers) {
      const Carrier& c = found_.carriers[id];
      const Patch& patch = w_.patch[c.operand];
      for (const bool forward : {true, false}) {
        FaceId face;
        if (c.entity.is_face()) {
          face = c.entity.face();
        } else {
          const unsigned side = forward == c.along ? 0 : 1;
          face = patch.brep.face_of(Brep::half_edge(c.entity.edge(), side));
          if (!patch.is_real(face))
            throw InternalError("a face that meets the other boundary was not loaded");
        }
        found_.half_planes.add({c.operand, forward, id, face, patch.plane(face)});
      }
    }
    segment_.half_planes = found_.half_planes.ids_from(first);
  }

  void find_line() {
    segment_.plane[0] = half_planes()[0].plane;
    for (const HalfPlane& h : half_planes()) {
      const int axis = kernel_.cross_axis(segment_.plane[0], h.plane);
      line_ = AroundLine(kernel_, axis, axis < 0 ? Sign::zero : sense(axis));
      if (axis < 0) continue;
      segment_.plane[1] = h.plane;
      return;
    }
  }

  void sort() {
    auto planes = half_planes();
    const LineSide start = line_side(planes[0]);
    sorted_.clear();
    for (const HalfPlane& h : planes) sorted_.push_back({line_.quarter(start, line_side(h)), h});
    std::sort(sorted_.begin(), sorted_.end(), [&](const Sorted& p, const Sorted& q) {
      if (p.quarter != q.quarter) return p.quarter < q.quarter;
      const Sign sign = line_.turn(line_side(p.half_plane), line_side(q.half_plane));
      if (sign != Sign::zero) return sign == Sign::positive;
      if (p.half_plane.operand != q.half_plane.operand)
        return p.half_plane.operand < q.half_plane.operand;
      return before(p.half_plane, q.half_plane);
    });
    for (std::size_t i = 0; i < sorted_.size(); ++i) planes[i] = sorted_[i].half_plane;
  }

  // In the order in which they were found.
  static bool before(const HalfPlane& i, const HalfPlane& j) {
    return i.carrier != j.carrier ? i.carrier < j.carrier : i.forward && !j.forward;
  }

  // Material lies behind a forward half-plane and before a backward one, counter-clockwise.
  void classify() {
    auto planes = half_planes();
    PerOperand<bool> in;
    for (const HalfPlane& h : planes) in[h.operand] = !h.forward;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      HalfPlane& h = planes[i];
      if (in[h.operand] != h.forward)
        throw InternalError("the material around a line does not alternate");
      const HalfPlane* partner = nullptr;
      for (const HalfPlane* beside :
           {&planes[i + 1 < planes.size() ? i + 1 : 0], &planes[i > 0 ? i - 1 : planes.size() - 1]})
        if (beside->operand != h.operand && line_.tied(line_side(h), line_side(*beside)))
          partner = beside;
      if (partner)
        h.cls = partner->forward == h.forward ? Class::on_plus : Class::on_minus;
      else
        h.cls = in[other(h.operand)] ? Class::in : Class::out;
      in[h.operand] = !h.forward;
    }
  }

  void pair_wedges(Operation operation, std::vector<WedgePair>& wedges) {
    kept_.clear();
    for (const HalfPlaneId i : segment_.half_planes) {
      const HalfPlane& h = found_.half_planes[i];
      if (kept(operation, h.operand, h.cls)) kept_.push_back(i);
    }
    const auto starts_material = [&](HalfPlaneId i) {
      const HalfPlane& h = found_.half_planes[i];
      return (h.forward == reversed(operation, h.operand)) != wanted_.of_complement;
    };
    for (std::size_t k = 0; k < kept_.size(); ++k) {
      const HalfPlaneId i = kept_[k], j = kept_[k + 1 < kept_.size() ? k + 1 : 0];
      if (starts_material(i) == starts_material(j))
        throw InternalError("the result's material around a line does not alternate");
      if (!starts_material(i)) continue;
      wedges.push_back({i, j});
      // A carrier is cut unless both its sides go, or stay and bound the same wedge.
      Carrier& p = carrier_of(found_.half_planes[i]);
      Carrier& q = carrier_of(found_.half_planes[j]);
      if (&p != &q) p.cut = q.cut = true;
    }
  }

  void cut_between_classes() {
    one_side_.assign(segment_.carriers.size(), nullptr);
    for (const HalfPlane& h : half_planes()) {
      const HalfPlane*& one_side = one_side_[segment_.carriers.index(h.carrier)];
      if (!one_side)
        one_side = &h;
      else if (one_side->cls != h.cls)
        carrier_of(h).cut = true;
    }
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& contacts_;
  const Wanted& wanted_;
  Neighborhoods found_;
  Segment segment_{};
  AroundLine line_;
  std::vector<Sorted> sorted_;
  // Per face and edge of each patch: the last segment that it carries.
  PerOperand<Table<FaceId, SegmentId>> last_with_face_;
  PerOperand<Table<EdgeId, SegmentId>> last_with_edge_;
  std::vector<HalfPlaneId> kept_;
  std::vector<const HalfPlane*> one_side_;  // per carrier of the segment
};

std::vector<Keyed> in_order(const std::vector<SegmentRecord>& records) {
  std::vector<Keyed> order;
  order.reserve(records.size());
  for (const SegmentRecord& r : records)
    order.push_back({std::uint64_t(r.place[0].value()) << 32 | r.place[1].value(),
                     std::uint64_t(r.on[Operand::a].code()) << 32 | r.on[Operand::b].code(),
                     static_cast<std::uint32_t>(order.size())});
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace

Neighborhoods find_neighborhoods(const Workspace& w, const Contacts& contacts,
                                 const Wanted& wanted) {
  const std::vector<Keyed> order = in_order(contacts.segments);
  SegmentBuilder build(w, contacts, wanted);
  for (std::size_t from = 0, to; from < order.size(); from = to) {
    for (to = from + 1; to < order.size() && order[to].places == order[from].places;) ++to;
    w.check_cancelled();
    build(std::span(order).subspan(from, to - from));
  }
  return build.take();
}

}  // namespace sectile
