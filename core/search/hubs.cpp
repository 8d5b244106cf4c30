#include "search/hubs.h"

#include <algorithm>

#include "search/seen_arc.h"

namespace sectile {
namespace {

std::vector<std::uint32_t> corners_at_points(const Brep& brep) {
  std::uint32_t last = 0;
  for (const PointId p : brep.point) last = std::max(last, p.value());
  std::vector<std::uint32_t> count(std::size_t(last) + 1, 0);
  for (const VertexId v : brep.origin) ++count[brep.point_of(v).value()];
  return count;
}

}  // namespace

Hubs::Hubs(const Brep& brep) {
  if (brep.face_count() < least_faces) return;
  const std::vector<std::uint32_t> corners = corners_at_points(brep);
  std::vector<std::uint32_t> hub_at;
  for (std::size_t p = 0; p < corners.size(); ++p) {
    if (corners[p] < least_faces) continue;
    if (hub_at.empty()) hub_at.assign(corners.size(), none);
    hub_at[p] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(PointId(p));
  }
  if (points_.empty()) return;
  find_spines(brep, hub_at);
  of_face_.assign(brep.face_count(), none);
  face_end_.assign(points_.size(), 0);
  for (std::size_t f = 0; f < of_face_.size(); ++f) {
    std::uint32_t most = 0;
    for_each_in_face(brep, FaceId(f), [&](HalfEdgeId h) {
      const std::uint32_t p = brep.point_of(brep.from(h)).value();
      if (hub_at[p] == none || corners[p] <= most) return;
      most = corners[p];
      of_face_[f] = hub_at[p];
    });
    if (of_face_[f] != none) ++face_end_[of_face_[f]];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& e : face_end_) {
    const std::uint32_t count = e;
    e = end;
    end += count;
  }
  faces_.resize(end);
  for (std::size_t f = 0; f < of_face_.size(); ++f)
    if (of_face_[f] != none) faces_[face_end_[of_face_[f]]++] = FaceId(f);
}

void Hubs::find_spines(const Brep& brep, const std::vector<std::uint32_t>& hub_at) {
  if (points_.size() < 2) return;
  std::vector<Spine> all;
  for (const EdgeId e : brep.edges()) {
    const HalfEdgeId h = Brep::half_edge(e);
    const auto hub = [&](VertexId v) { return hub_at[brep.point_of(v).value()]; };
    const std::uint32_t from = hub(brep.from(h)), to = hub(brep.to(h));
    if (from != none && to != none && from != to) all.push_back(Spine::between(from, to));
  }
  spines_ = spines_among(std::move(all), least_faces / 2);
}

std::vector<Hubs::Spine> Hubs::spines_among(std::vector<Spine> edges, std::uint32_t least) {
  std::sort(edges.begin(), edges.end());
  std::vector<Spine> spines;
  for (auto first = edges.begin(), last = first; first != edges.end(); first = last) {
    last = std::upper_bound(first, edges.end(), *first);
    if (last - first >= least) spines.push_back(*first);
  }
  return spines;
}

std::vector<SeenArc> arcs_seen_from(PointId hub, const Brep& brep, const Geometry& geometry,
                                    std::span<const FaceId> faces) {
  std::vector<SeenArc> arcs;
  arcs.reserve(faces.size());
  std::vector<Vec3> others;
  for (const FaceId f : faces) {
    others.clear();
    for_each_in_loop(brep, brep.outer_loop[f], [&](HalfEdgeId h) {
      const PointId p = brep.point_of(brep.from(h));
      if (p != hub) others.push_back(geometry.position(p));
    });
    arcs.push_back(SeenArc::from_point(geometry.position(hub), others));
  }
  return arcs;
}

}  // namespace sectile
