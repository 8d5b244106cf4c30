#include "boolean/neighborhoods.h"

#include <algorithm>
#include <utility>

#include "boolean/line.h"
#include "boolean/tables.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

class SegmentBuilder {
 public:
  SegmentBuilder(Workspace& w, std::span<const Operation> wanted)
      : w_(w), kernel_(w.tests()), wanted_(wanted) {
    for (int s = 0; s < 2; ++s) {
      last_with_face_[s].resize(w.patch[s].brep.face_count());
      last_with_edge_[s].resize(w.patch[s].brep.edge_count());
    }
  }

  void operator()(std::span<const SegmentRecord> records) {
    segment_ = {};
    segment_.place[0] = records[0].place[0];
    segment_.place[1] = records[0].place[1];
    segment_.first_carrier = static_cast<std::uint32_t>(w_.carriers.size());
    segment_.first_half_plane = static_cast<std::uint32_t>(w_.half_planes.size());
    for (const SegmentRecord& r : records)
      for (std::uint8_t s = 0; s < 2; ++s) add_carrier(s, r);
    segment_.carrier_count =
        static_cast<std::uint32_t>(w_.carriers.size()) - segment_.first_carrier;
    add_half_planes();
    find_planes();
    sort();
    classify();
    for (std::size_t i = 0; i < wanted_.size(); ++i) pair_wedges(wanted_[i], w_.wedges[i]);
    if (wanted_.empty()) cut_between_classes();
    w_.segments.push_back(segment_);
  }

 private:
  std::span<Carrier> carriers() { return std::span(w_.carriers).subspan(segment_.first_carrier); }
  std::span<HalfPlane> half_planes() {
    return std::span(w_.half_planes).subspan(segment_.first_half_plane);
  }

  void add_carrier(std::uint8_t s, const SegmentRecord& r) {
    auto& last_with = r.on[s].is_edge() ? last_with_edge_[s] : last_with_face_[s];
    const auto number = static_cast<std::uint32_t>(w_.segments.size() + 1);
    if (std::exchange(last_with[r.on[s].index()], number) == number) return;
    Carrier carrier{};
    carrier.solid = s;
    carrier.entity = r.on[s];
    carrier.end[0] = r.end[s][0];
    carrier.end[1] = r.end[s][1];
    if (carrier.entity.is_edge()) carrier.along = runs_along(s, carrier.entity.edge());
    w_.carriers.push_back(carrier);
  }

  bool runs_along(int s, EdgeId e) const {
    const Patch& patch = w_.patch[s];
    const HalfEdgeId h = Brep::half_edge(e);
    const auto [a, b] = line_planes(patch, h);
    const int axis = kernel_.cross_axis(a, b);
    return kernel_.compare(patch.brep.point_of(patch.brep.from(h)),
                           patch.brep.point_of(patch.brep.to(h)), axis) ==
           kernel_.compare(w_.point(segment_.place[0]), w_.point(segment_.place[1]), axis);
  }

  void add_half_planes() {
    for (std::uint32_t i = 0; i < segment_.carrier_count; ++i) {
      const Carrier& c = carriers()[i];
      const Patch& patch = w_.patch[c.solid];
      const std::uint32_t index = segment_.first_carrier + i;
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
        w_.half_planes.push_back({c.solid, forward, index, face, patch.plane(face)});
      }
    }
    segment_.half_plane_count =
        static_cast<std::uint32_t>(w_.half_planes.size()) - segment_.first_half_plane;
  }

  void find_planes() {
    segment_.plane[0] = half_planes()[0].plane;
    for (const HalfPlane& h : half_planes()) {
      axis_ = kernel_.cross_axis(segment_.plane[0], h.plane);
      if (axis_ < 0) continue;
      segment_.plane[1] = h.plane;
      line_ = kernel_.compare(w_.point(segment_.place[0]), w_.point(segment_.place[1]), axis_);
      return;
    }
  }

  // The sign of (m_i × m_j) · d, where m is the normal, turned back for backward half-planes: the
  // half-plane's own direction a quarter turn on.
  Sign turn(const HalfPlane& i, const HalfPlane& j) const {
    if (axis_ < 0) return Sign::zero;
    const Sign sign = kernel_.cross(i.plane, j.plane, axis_) * line_;
    return i.forward == j.forward ? sign : -sign;
  }
  bool same_way(const HalfPlane& i, const HalfPlane& j) const {
    return kernel_.same_direction(i.plane, j.plane) == (i.forward == j.forward);
  }
  int quarter(const HalfPlane& start, const HalfPlane& h) const {
    switch (turn(start, h)) {
      case Sign::positive:
        return 1;
      case Sign::negative:
        return 3;
      case Sign::zero:
        break;
    }
    return same_way(start, h) ? 0 : 2;
  }

  void sort() {
    const HalfPlane start = half_planes()[0];
    auto planes = half_planes();
    keyed_.clear();
    for (const HalfPlane& h : planes) keyed_.push_back({quarter(start, h), h});
    std::sort(keyed_.begin(), keyed_.end(), [&](const Keyed& p, const Keyed& q) {
      if (p.quarter != q.quarter) return p.quarter < q.quarter;
      const Sign sign = turn(p.half_plane, q.half_plane);
      if (sign != Sign::zero) return sign == Sign::positive;
      if (p.half_plane.solid != q.half_plane.solid) return p.half_plane.solid < q.half_plane.solid;
      return before(p.half_plane, q.half_plane);
    });
    for (std::size_t i = 0; i < keyed_.size(); ++i) planes[i] = keyed_[i].half_plane;
  }

  // In the order in which they were found.
  static bool before(const HalfPlane& i, const HalfPlane& j) {
    return i.carrier != j.carrier ? i.carrier < j.carrier : i.forward && !j.forward;
  }

  bool tied(const HalfPlane& i, const HalfPlane& j) const {
    return turn(i, j) == Sign::zero && same_way(i, j);
  }

  // Material lies behind a forward half-plane and before a backward one, counter-clockwise.
  void classify() {
    auto planes = half_planes();
    bool in[2] = {false, false};
    for (const HalfPlane& h : planes) in[h.solid] = !h.forward;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      HalfPlane& h = planes[i];
      if (in[h.solid] != h.forward)
        throw InternalError("the material around a line does not alternate");
      const HalfPlane& next = planes[i + 1 < planes.size() ? i + 1 : 0];
      const HalfPlane& last = planes[i > 0 ? i - 1 : planes.size() - 1];
      const HalfPlane* partner = nullptr;
      if (next.solid != h.solid && tied(h, next)) partner = &next;
      if (last.solid != h.solid && tied(h, last)) partner = &last;
      if (partner)
        h.cls = partner->forward == h.forward ? Class::on_plus : Class::on_minus;
      else
        h.cls = in[1 - h.solid] ? Class::in : Class::out;
      in[h.solid] = !h.forward;
    }
  }

  void pair_wedges(Operation operation, std::vector<WedgePair>& wedges) {
    auto planes = half_planes();
    auto& kept_planes = kept_planes_;
    kept_planes.clear();
    for (std::uint32_t i = 0; i < planes.size(); ++i)
      if (kept(operation, planes[i].solid, planes[i].cls)) kept_planes.push_back(i);
    const auto starts_material = [&](std::uint32_t i) {
      return (planes[i].forward == reversed(operation, planes[i].solid)) != w_.of_complement;
    };
    const std::size_t count = kept_planes.size();
    auto& partner = partner_;
    partner.assign(planes.size(), no_element);
    for (std::size_t k = 0; k < count; ++k) {
      const std::uint32_t i = kept_planes[k], j = kept_planes[k + 1 < count ? k + 1 : 0];
      if (starts_material(i) == starts_material(j))
        throw InternalError("the result's material around a line does not alternate");
      if (!starts_material(i)) continue;
      partner[i] = j;
      partner[j] = i;
      wedges.push_back({segment_.first_half_plane + i, segment_.first_half_plane + j});
    }
    // A carrier is cut unless both its sides go, or stay and bound the same wedge.
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
      const std::uint32_t j = partner[i];
      if (j != no_element && planes[j].carrier != planes[i].carrier)
        w_.carriers[planes[i].carrier].cut = true;
    }
  }

  void cut_between_classes() {
    partner_.assign(segment_.carrier_count, no_element);
    const auto planes = half_planes();
    for (std::uint32_t i = 0; i < planes.size(); ++i) {
      std::uint32_t& other_side = partner_[planes[i].carrier - segment_.first_carrier];
      if (other_side == no_element)
        other_side = i;
      else if (planes[other_side].cls != planes[i].cls)
        w_.carriers[planes[i].carrier].cut = true;
    }
  }

  Workspace& w_;
  const Kernel& kernel_;
  std::span<const Operation> wanted_;
  Segment segment_{};
  struct Keyed {
    int quarter;
    HalfPlane half_plane;
  };
  std::vector<Keyed> keyed_;
  // Per face and edge of each patch: the last segment that it carries, counted from 1.
  std::vector<std::uint32_t> last_with_face_[2], last_with_edge_[2];
  std::vector<std::uint32_t> kept_planes_, partner_;
  int axis_ = -1;
  Sign line_ = Sign::zero;
};

}  // namespace

void find_neighborhoods(Workspace& w, std::span<const Operation> wanted) {
  w.wedges.assign(wanted.size(), {});
  std::sort(w.records.begin(), w.records.end(), [](const SegmentRecord& p, const SegmentRecord& q) {
    if (p.place[0] != q.place[0]) return p.place[0] < q.place[0];
    if (p.place[1] != q.place[1]) return p.place[1] < q.place[1];
    if (p.on[0] != q.on[0]) return p.on[0] < q.on[0];
    return p.on[1] < q.on[1];
  });
  SegmentBuilder build(w, wanted);
  const std::span<const SegmentRecord> records(w.records);
  for (std::size_t from = 0, to; from < records.size(); from = to) {
    for (to = from + 1; to < records.size() && records[to].place[0] == records[from].place[0] &&
                        records[to].place[1] == records[from].place[1];)
      ++to;
    w.check_cancelled();
    build(records.subspan(from, to - from));
  }
}

}  // namespace sectile
