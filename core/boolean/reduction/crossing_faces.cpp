#include "boolean/reduction/crossing_faces.h"

#include <algorithm>

#include "boolean/collect.h"
#include "sectile/errors.h"

namespace sectile {

void CrossingFaces::operator()(const PairOfFaces& pair) {
  pair_ = pair;
  if (!cross_in_one_segment()) cross_in_points();
}

// As nearly everywhere: there are just two edges that pierce the other face. The faces overlap
// between them, from where the line enters one face to where it leaves one. False if it is not so.
bool CrossingFaces::cross_in_one_segment() {
  if (!find_piercings()) return false;
  if (piercings_.empty()) return true;
  if (piercings_.size() != 2) return false;
  const Piercing &p = piercings_[0], &q = piercings_[1];
  if (p.enters == q.enters || p.place == q.place) return false;
  p.enters ? add(p, q) : add(q, p);
  return true;
}

// False if anything else meets in them. Which way the line goes through an edge is known without
// arithmetic: it enters a where a half-edge goes from the inner to the outer side of b, and b where
// one goes from the outer to the inner side of a.
bool CrossingFaces::find_piercings() {
  piercings_.clear();
  for (const Operand s : both_operands)
    for (const SidedHalfEdge& i : table_.meeting(pair_, s)) {
      if (i.from == Sign::zero) return false;
      const EdgeId e = Brep::edge_of(i.h);
      const auto hits = table_.find(s, w_.patch[s].tested(e), pair_.face[other(s)]);
      if (hits.empty()) continue;
      if (hits.size() > 1 || !hits[0].found.is_face() || piercings_.size() == 2) return false;
      const bool outwards = i.to == Sign::positive;
      piercings_.push_back(
          {s, e, found_.contacts[hits[0].contact].place, s == Operand::a ? outwards : !outwards});
    }
  return true;
}

void CrossingFaces::add(const Piercing& from, const Piercing& to) {
  SegmentRecord record;
  record.place[0] = from.place;
  record.place[1] = to.place;
  record.sense = Sign::positive;
  for (const Operand s : both_operands) {
    const Entity face = pair_.face[s];
    record.on[s] = face;
    record.end[s] = {s == from.solid ? Entity(from.edge) : face,
                     s == to.solid ? Entity(to.edge) : face};
  }
  emit(record);
}

void CrossingFaces::cross_in_points() {
  items_.clear();
  edges_on_line_.clear();
  gather(Operand::a);
  gather(Operand::b);
  if (items_.empty()) return;
  const PlaneId a = w_.patch[Operand::a].plane(pair_.face[Operand::a]),
                b = w_.patch[Operand::b].plane(pair_.face[Operand::b]);
  line_ = kernel_.main_cross(a, b);
  if (!find_points()) return;
  if (add_items_within()) find_points();
  // n(a) × n(b), as seen in the plane of each.
  direction_[Operand::a] = {b, Sign::positive};
  direction_[Operand::b] = {a, Sign::negative};
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) between(points_[i], points_[i + 1]);
}

void CrossingFaces::gather(Operand s) {
  const Patch& patch = w_.patch[s];
  for (const SidedHalfEdge& i : table_.meeting(pair_, s)) {
    if (i.from == Sign::zero && i.to == Sign::zero) edges_on_line_.push_back({s, i.h});
    if (i.from == Sign::zero) {
      const VertexId v = patch.brep.from(i.h);
      const auto hits = table_.find(s, patch.tested(v), pair_.face[other(s)]);
      if (const CrowdedCorners::Fan* fan = crowded_fan(patch, pair_.face[s], v))
        add(s, fan->vertices[0], hits, HalfEdgeId());
      else
        add(s, v, hits, i.h);
    } else {
      const EdgeId e = Brep::edge_of(i.h);
      add(s, e, table_.find(s, patch.tested(e), pair_.face[other(s)]), i.h);
    }
  }
}

void CrossingFaces::add(Operand s, Entity piercer, std::span<const Hit> hits, HalfEdgeId h) {
  if (hits.empty()) return;
  const PlaceId place = found_.contacts[hits[0].contact].place;
  items_.push_back({place, s, {piercer, h}});
  bounds_.clear();
  for (const Hit& hit : hits)
    add_items(w_.patch[other(s)], pair_.face[other(s)], hit.found, bounds_);
  for (const BoundaryItem& item : bounds_) items_.push_back({place, other(s), item});
}

bool CrossingFaces::precedes(PointId p, PointId q) const {
  return kernel_.compare(p, q, line_.axis) == line_.sign;
}

// Groups the items by place, and puts the places in the order of the line; false for one place.
bool CrossingFaces::find_points() {
  std::sort(items_.begin(), items_.end());
  items_.erase(std::unique(items_.begin(), items_.end()), items_.end());
  points_.clear();
  for (auto from = items_.begin(), to = from; from != items_.end(); from = to) {
    while (to != items_.end() && to->place == from->place) ++to;
    const auto second = std::find_if(from, to, [](const Item& i) { return i.solid == Operand::b; });
    points_.push_back({from->place, {{{from, second}, {second, to}}}});
  }
  std::sort(points_.begin(), points_.end(), [&](const Point& p, const Point& q) {
    return precedes(found_.point(p.place), found_.point(q.place));
  });
  return points_.size() > 1;
}

// A face that touches itself may have places within an edge; the edge bounds it there too.
bool CrossingFaces::add_items_within() {
  const std::size_t known = items_.size();
  std::vector<Item> within;
  for (const EdgeOnLine& e : edges_on_line_) {
    const Brep& brep = w_.patch[e.solid].brep;
    PointId from = brep.point_of(brep.from(e.h)), to = brep.point_of(brep.to(e.h));
    if (!precedes(from, to)) std::swap(from, to);
    auto p = std::partition_point(points_.begin(), points_.end(), [&](const Point& i) {
      return !precedes(from, found_.point(i.place));
    });
    for (; p != points_.end() && precedes(found_.point(p->place), to); ++p)
      within.push_back({p->place, e.solid, {Brep::edge_of(e.h), e.h}});
  }
  append(items_, within);
  return items_.size() > known;
}

void CrossingFaces::between(const Point& p, const Point& q) {
  using Where = Standing::Where;
  SegmentRecord record;
  record.place[0] = p.place;
  record.place[1] = q.place;
  record.sense = Sign::positive;
  // Beside one of the faces, the other one may end anywhere.
  for (const Operand s : both_operands) {
    const Standing from = stands(s, p, direction_[s]);
    if (from.where != Where::inside) return;
    record.on[s] = pair_.face[s];
    record.end[s][0] = from.entity;
  }
  for (const Operand s : both_operands) {
    const Standing to = stands(s, q, -direction_[s]);
    if (to.where != Where::inside)
      throw InternalError("a line leaves a face without crossing its boundary");
    record.end[s][1] = to.entity;
  }
  emit(record);
}

Standing CrossingFaces::stands(Operand s, const Point& p, const Direction& direction) {
  bounds_.clear();
  for (const Item& item : p.items[s]) bounds_.push_back(item.of);
  return standing(kernel_, w_.patch[s], pair_.face[s], bounds_, direction);
}

}  // namespace sectile
