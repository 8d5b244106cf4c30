#include "boolean/common_hubs.h"

#include <algorithm>
#include <tuple>

#include "boolean/boolean.h"
#include "boolean/collect.h"
#include "boolean/line.h"

namespace sectile {
namespace {

bool same_point(const Geometry& a, PointId p, const Geometry& b, PointId q) {
  if (!(a.position(p) == b.position(q))) return false;
  if (a.is_explicit(p) && b.is_explicit(q)) return true;
  Geometry both;
  const PointId mine = load_point(a, p, both), across = load_point(b, q, both);
  return Kernel(both).same_point(mine, across);
}

}  // namespace

CommonHubs::CommonHubs(const SolidData& a, const SolidData& b,
                       const PerOperand<std::span<const std::uint32_t>>& slots)
    : data_{&a, &b} {
  for (const Operand s : both_operands) {
    first_[s].resize(data_[s]->slots().size());
    for (const std::uint32_t slot : slots[s]) {
      const std::size_t count = hubs(s, slot).size();
      first_[s][slot] = static_cast<std::uint32_t>(place_[s].size());
      for (std::uint32_t h = 0; h < count; ++h) order_.push_back({s, slot, h});
      place_[s].resize(place_[s].size() + count);
    }
  }
  if (place_[Operand::a].empty() || place_[Operand::b].empty()) order_.clear();
  std::sort(order_.begin(), order_.end(), [&](const Hub& g, const Hub& h) {
    const Vec3 &p = position(g), &q = position(h);
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  for (std::size_t i = 0; i < order_.size(); ++i) {
    std::size_t j = i;
    while (j > 0 && position(order_[j - 1]) == position(order_[i]) &&
           !are_at_one_place(order_[j - 1], order_[i]))
      --j;
    const bool known = j > 0 && position(order_[j - 1]) == position(order_[i]);
    place_of(order_[i]) = known ? place_of(order_[j - 1]) : static_cast<std::uint32_t>(i);
  }
  std::stable_sort(order_.begin(), order_.end(),
                   [&](const Hub& g, const Hub& h) { return place_of(g) < place_of(h); });
}

bool CommonHubs::are_at_one_place(const Hub& g, const Hub& h) const {
  return same_point(block(g).geometry(), point(g), block(h).geometry(), point(h));
}

// Calls visit(fan of a, fan of b, rounded place).
template <class Visit>
void CommonHubs::for_each_place(const Visit& visit) const {
  for (std::size_t from = 0, to; from < order_.size(); from = to) {
    PerOperand<Fan> fan;
    for (to = from; to < order_.size() && place_of(order_[to]) == place_of(order_[from]); ++to) {
      const Hub& h = order_[to];
      const auto faces = hubs(h.solid, h.slot).faces(h.number);
      Fan& mine = fan[h.solid];
      for (const FaceId f : faces) mine.faces.push_back(data_[h.solid]->face(h.slot, f));
      append(mine.directions,
             direction_boxes(block(h).brep(), block(h).geometry(), point(h), faces));
    }
    if (!fan[Operand::a].faces.empty() && !fan[Operand::b].faces.empty())
      visit(fan[Operand::a], fan[Operand::b], position(order_[from]));
  }
}

void CommonHubs::add_pairs(FacePairs& pairs) const {
  for_each_place([&](const Fan& a, const Fan& b, const Vec3&) {
    BoxTree::overlaps(BoxTree(a.directions), BoxTree(b.directions),
                      [&](std::uint32_t i, std::uint32_t j) {
                        pairs.push_back({a.faces[i], b.faces[j]});
                      });
  });
}

PerOperand<std::vector<FaceId>> CommonHubs::faces() const {
  PerOperand<std::vector<FaceId>> faces;
  for_each_place([&](const Fan& a, const Fan& b, const Vec3&) {
    append(faces[Operand::a], a.faces);
    append(faces[Operand::b], b.faces);
  });
  return faces;
}

namespace {

std::vector<VertexId> vertices_at(const Workspace& w, Operand s, std::span<const FaceId> fan,
                                  const Vec3& place) {
  const Patch& patch = w.patch[s];
  std::vector<VertexId> vertices;
  for (const FaceId f : fan)
    for_each_in_face(patch.brep, loaded_face(patch, f), [&](HalfEdgeId h) {
      const VertexId v = patch.brep.from(h);
      if (w.geometry.position(patch.brep.point_of(v)) == place) vertices.push_back(v);
    });
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

// One of the vertices for each point at the rounded place: as a rule, there is one point.
std::vector<VertexId> choose_tested(const Workspace& w, Patch& patch,
                                    std::span<const VertexId> vertices) {
  std::vector<VertexId> tested;
  for (const VertexId v : vertices) {
    const auto at = std::ranges::find_if(tested, [&](VertexId t) {
      return w.tests().same_point(patch.brep.point_of(t), patch.brep.point_of(v));
    });
    if (at == tested.end()) {
      tested.push_back(v);
      continue;
    }
    if (patch.tested.empty())
      for (const VertexId each : patch.brep.vertices()) patch.tested.add(each);
    patch.tested[v] = *at;
  }
  return tested;
}

// Does a face have an edge with the point between its ends?
bool passes_through(const Workspace& w, Operand s, FaceId face, PointId point) {
  const Patch& patch = w.patch[s];
  const Vec3& at = w.geometry.position(point);
  bool passes = false;
  for_each_in_face(patch.brep, face, [&](HalfEdgeId h) {
    const PointId from = patch.brep.point_of(patch.brep.from(h)),
                  to = patch.brep.point_of(patch.brep.to(h));
    Bounds near;
    near.add(w.geometry.position(from));
    near.add(w.geometry.position(to));
    if (passes || !near.contains(at)) return;
    const auto [a, b] = line_planes(patch, h);
    passes = w.tests().side(point, a) == Sign::zero && w.tests().side(point, b) == Sign::zero &&
             w.tests().is_between(from, point, to);
  });
  return passes;
}

// Of the vertices of one fan of operand s with faces of the other one: add(owner, face).
template <class Add>
void add_pairs_of_owners(Workspace& w, Operand s, std::span<const FaceId> mine,
                         std::span<const FaceId> across, const Vec3& place, const Add& add) {
  Patch& patch = w.patch[s];
  const std::vector<VertexId> vertices = vertices_at(w, s, mine, place);
  for (const VertexId tested : choose_tested(w, patch, vertices)) {
    for (const FaceId f : across) {
      const FaceId face = loaded_face(w.patch[other(s)], f);
      add(patch.owner(tested), face);
      if (!passes_through(w, other(s), face, patch.brep.point_of(tested))) continue;
      for (const VertexId v : vertices)
        if (patch.tested_for(v) == tested) add(patch.owner(v), face);
    }
  }
}

}  // namespace

void CommonHubs::add_pairs_of_owners(Workspace& w, FacePairs& pairs) const {
  for_each_place([&](const Fan& a, const Fan& b, const Vec3& place) {
    sectile::add_pairs_of_owners(w, Operand::a, a.faces, b.faces, place, [&](FaceId f, FaceId g) {
      pairs.push_back({f, g});
    });
    sectile::add_pairs_of_owners(w, Operand::b, b.faces, a.faces, place, [&](FaceId g, FaceId f) {
      pairs.push_back({f, g});
    });
  });
}

}  // namespace sectile
