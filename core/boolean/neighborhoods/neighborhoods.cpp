#include "boolean/neighborhoods/neighborhoods.h"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "boolean/collect.h"
#include "boolean/line.h"
#include "boolean/neighborhoods/row_sweep.h"
#include "geometry/around_line.h"
#include "numbers/threshold.h"
#include "search/bucket_sort.h"
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

// The faces and edges that carry one segment: few, as a rule.
class CarriersSeen {
 public:
  void clear() {
    few_.clear();
    many_.clear();
  }
  /// True if it was not there.
  bool add(Operand s, Entity e) {
    const std::uint64_t key = std::uint64_t(s) << 32 | e.code();
    if (std::find(few_.begin(), few_.end(), key) != few_.end()) return false;
    if (few_.size() == most_of_few) return many_.insert(key).second;
    few_.push_back(key);
    return true;
  }
  std::size_t count() const { return few_.size() + many_.size(); }

 private:
  static constexpr std::size_t most_of_few = threshold(12, 1);
  std::vector<std::uint64_t> few_;
  std::set<std::uint64_t> many_;
};

// Makes segments whose places in the tables are known.
class SegmentBuilder {
 public:
  /// `first`: of the carriers of the first segment. Wedges are collected for each wanted operation.
  SegmentBuilder(const Workspace& w, const Contacts& contacts, const Wanted& wanted,
                 CarrierId first, Neighborhoods& found, std::vector<std::vector<WedgePair>>& wedges)
      : w_(w),
        kernel_(w.tests()),
        contacts_(contacts),
        wanted_(wanted),
        found_(found),
        wedges_(wedges),
        next_carrier_(first),
        line_(kernel_, -1, Sign::zero) {
    wedges_.resize(wanted.operations.size());
  }

  void operator()(SegmentId id, std::span<const Keyed> records) {
    segment_ = {};
    const SegmentRecord& any = contacts_.segments[records[0].record];
    segment_.place[0] = any.place[0];
    segment_.place[1] = any.place[1];
    if (records.size() == 1 && any.sense != Sign::zero)
      cross_faces(any);
    else
      meet_in_any_way(records);
    found_.segments[id] = segment_;
  }

 private:
  struct Sorted {
    int quarter;
    HalfPlane half_plane;
  };

  void meet_in_any_way(std::span<const Keyed> records) {
    add_carriers(records);
    add_half_planes();
    find_line();
    sort();
    classify();
    for (std::size_t i = 0; i < wanted_.operations.size(); ++i)
      pair_wedges(wanted_.operations[i], wedges_[i]);
    if (wanted_.operations.empty()) cut_between_classes();
    find_directions();
  }

  // Two faces that cross each other, as nearly everywhere: half-planes of A and of B take turns, of
  // each operand one is within the other, and both faces are cut.
  void cross_faces(const SegmentRecord& r) {
    const FaceId face_a = r.on[Operand::a].face(), face_b = r.on[Operand::b].face();
    const PlaneId a = w_.patch[Operand::a].plane(face_a), b = w_.patch[Operand::b].plane(face_b);
    segment_.plane[0] = a;
    segment_.plane[1] = b;
    const CarrierId of_a = next_carrier_, of_b(of_a.value() + 1u);
    found_.carriers[of_a] = crossed_face(Operand::a, r, {b, r.sense});
    found_.carriers[of_b] = crossed_face(Operand::b, r, {a, -r.sense});
    next_carrier_ = CarrierId(of_b.value() + 1u);
    segment_.carriers = {of_a, next_carrier_};
    segment_.half_planes = {HalfPlaneId(2 * of_a.value()), HalfPlaneId(2 * next_carrier_.value())};
    const bool left = r.sense == Sign::positive;  // of A's forward half-plane lies B's
    const std::span<HalfPlane> planes = half_planes();
    planes[0] = {Operand::a, true, of_a, face_a, a, left ? Class::in : Class::out};
    planes[1] = {Operand::b, left, of_b, face_b, b, Class::out};
    planes[2] = {Operand::a, false, of_a, face_a, a, left ? Class::out : Class::in};
    planes[3] = {Operand::b, !left, of_b, face_b, b, Class::in};
    for (std::size_t i = 0; i < wanted_.operations.size(); ++i)
      pair_wedges(wanted_.operations[i], wedges_[i]);
  }

  static Carrier crossed_face(Operand s, const SegmentRecord& r, const Direction& direction) {
    return {s, r.on[s], {r.end[s][0], r.end[s][1]}, true, true, direction};
  }

  Carrier& carrier_of(const HalfPlane& h) { return found_.carriers[h.carrier]; }
  std::span<HalfPlane> half_planes() { return found_.half_planes[segment_.half_planes]; }

  void add_carriers(std::span<const Keyed> records) {
    segment_.carriers = {next_carrier_, next_carrier_};
    seen_.clear();
    for (const Keyed& r : records)
      for (const Operand s : both_operands) add_carrier(s, contacts_.segments[r.record]);
    next_carrier_ = segment_.carriers.end_id();
  }

  void add_carrier(Operand s, const SegmentRecord& r) {
    if (!seen_.add(s, r.on[s])) return;
    Carrier& carrier = found_.carriers[segment_.carriers.end_id()];
    segment_.carriers.extend();
    carrier.operand = s;
    carrier.entity = r.on[s];
    carrier.end[0] = r.end[s][0];
    carrier.end[1] = r.end[s][1];
    if (carrier.entity.is_edge()) carrier.along = runs_along(s, carrier.entity.edge());
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

  // Two for each carrier.
  void add_half_planes() {
    const HalfPlaneId first(2 * segment_.carriers.front().value());
    segment_.half_planes = {first, first};
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
        found_.half_planes[segment_.half_planes.end_id()] =
            HalfPlane{c.operand, forward, id, face, patch.plane(face)};
        segment_.half_planes.extend();
      }
    }
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
      for (const std::size_t beside :
           {i + 1 < planes.size() ? i + 1 : 0, i > 0 ? i - 1 : planes.size() - 1})
        if (planes[beside].operand != h.operand && sorted_[beside].quarter == sorted_[i].quarter &&
            line_.tied(line_side(h), line_side(planes[beside])))
          partner = &planes[beside];
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

  void find_directions() {
    for (const CarrierId id : segment_.carriers)
      if (Carrier& c = found_.carriers[id]; c.cut && c.entity.is_face())
        c.direction = direction_in(w_.patch[c.operand].plane(c.entity.face()));
  }

  Direction direction_in(PlaneId plane) const {
    const auto [p, q] = segment_.plane;
    const Sign sense = line_.cross(plane, p);
    return sense != Sign::zero ? Direction{p, sense} : Direction{q, line_.cross(plane, q)};
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& contacts_;
  const Wanted& wanted_;
  Neighborhoods& found_;
  std::vector<std::vector<WedgePair>>& wedges_;
  CarrierId next_carrier_;
  Segment segment_{};
  CarriersSeen seen_;
  AroundLine line_;
  std::vector<Sorted> sorted_;
  std::vector<HalfPlaneId> kept_;
  std::vector<const HalfPlane*> one_side_;  // per carrier of the segment
};

std::vector<Keyed> in_order(const Contacts& contacts) {
  std::vector<Keyed> order;
  order.reserve(contacts.segments.size());
  for (const SegmentRecord& r : contacts.segments)
    order.push_back({std::uint64_t(r.place[0].value()) << 32 | r.place[1].value(),
                     std::uint64_t(r.on[Operand::a].code()) << 32 | r.on[Operand::b].code(),
                     static_cast<std::uint32_t>(order.size())});
  bucket_sort(
      order, contacts.places.size(), [](const Keyed& k) { return k.places >> 32; }, std::less<>());
  return order;
}

// Makes the segments on all cores, some at a time.
class Finder {
 public:
  Finder(const Workspace& w, const Contacts& contacts, const Wanted& wanted)
      : w_(w), contacts_(contacts), wanted_(wanted), order_(in_order(contacts)) {
    for (std::size_t i = 0; i < order_.size(); ++i)
      if (i == 0 || order_[i].places != order_[i - 1].places)
        starts_.push_back(static_cast<std::uint32_t>(i));
    starts_.push_back(static_cast<std::uint32_t>(order_.size()));
  }

  Neighborhoods run() {
    const std::vector<CarrierId> first_carrier = first_carriers();
    found_.segments.resize(segment_count());
    found_.carriers.resize(first_carrier.back().value());
    found_.half_planes.resize(2 * found_.carriers.size());
    found_.wedges.resize(wanted_.operations.size());
    using Pairs = std::vector<std::vector<WedgePair>>;
    auto parts = collect_ranges<Pairs>(
        w_, segment_count(), chunk, [&](std::size_t first, std::size_t last, Pairs& wedges) {
          SegmentBuilder build(w_, contacts_, wanted_, first_carrier[first / chunk], found_,
                               wedges);
          for (std::size_t i = first; i < last; ++i) build(SegmentId(i), records(i));
        });
    for (Pairs& wedges : parts)
      for (std::size_t i = 0; i < wedges.size(); ++i)
        append(found_.wedges[i].pairs, std::move(wedges[i]));
    for (const Row& row : contacts_.rows) add_row(w_, contacts_, row, wanted_, found_);
    return std::move(found_);
  }

 private:
  static constexpr std::size_t chunk = threshold(256, 2);

  std::size_t segment_count() const { return starts_.size() - 1; }
  std::span<const Keyed> records(std::size_t segment) const {
    return std::span(order_).subspan(starts_[segment], starts_[segment + 1] - starts_[segment]);
  }

  // Of each chunk, and the end.
  std::vector<CarrierId> first_carriers() const {
    const auto counts = collect_ranges<std::size_t>(
        w_, segment_count(), chunk, [&](std::size_t first, std::size_t last, std::size_t& count) {
          CarriersSeen seen;
          for (std::size_t i = first; i < last; ++i) {
            if (records(i).size() == 1) {
              count += 2;
              continue;
            }
            seen.clear();
            for (const Keyed& r : records(i))
              for (const Operand s : both_operands) seen.add(s, contacts_.segments[r.record].on[s]);
            count += seen.count();
          }
        });
    std::vector<CarrierId> first = {CarrierId(0)};
    for (const std::size_t count : counts) first.push_back(CarrierId(first.back().value() + count));
    return first;
  }

  const Workspace& w_;
  const Contacts& contacts_;
  const Wanted& wanted_;
  const std::vector<Keyed> order_;
  std::vector<std::uint32_t> starts_;  // per segment: of its records; and the end
  Neighborhoods found_;
};

}  // namespace

Neighborhoods find_neighborhoods(const Workspace& w, const Contacts& contacts,
                                 const Wanted& wanted) {
  return Finder(w, contacts, wanted).run();
}

}  // namespace sectile
