#include "boolean/crowded_corners.h"

#include <algorithm>
#include <bit>
#include <tuple>

#include "boolean/ray_count.h"
#include "numbers/threshold.h"

namespace sectile {
namespace {

// A point with fewer corners than one of so many of the face's does not take long beside them.
constexpr std::size_t most_fans = 16;
constexpr std::size_t least_corners = threshold(32, 2);

PieceTree tree_of_edges(const Patch& patch, const Geometry& geometry,
                        std::span<const HalfEdgeId> half_edges) {
  const Brep& brep = patch.brep;
  std::vector<PieceTree::Edge> edges;
  edges.reserve(half_edges.size());
  for (const HalfEdgeId h : half_edges)
    edges.push_back({geometry.position(brep.point_of(brep.from(h))),
                     geometry.position(brep.point_of(brep.to(h)))});
  return PieceTree(edges);
}

// The corners of a face that are in one point, if there are very many.
class CrowdFinder {
 public:
  CrowdFinder(const Kernel& kernel, const Brep& brep, const Geometry& geometry,
              std::span<const HalfEdgeId> half_edges)
      : kernel_(kernel),
        brep_(brep),
        geometry_(geometry),
        half_edges_(half_edges),
        least_(std::max(least_corners, half_edges.size() / most_fans)) {}

  std::vector<CrowdedCorners::Crowd> run() {
    std::vector<CrowdedCorners::Crowd> crowds;
    const std::vector<VertexId> maybe = maybe_crowded();
    for (std::size_t from = 0, to; from < maybe.size(); from = to) {
      for (to = from; to < maybe.size() && place(maybe[to]) == place(maybe[from]);) ++to;
      if (to - from < least_) continue;
      add(std::span(maybe).subspan(from, to - from), crowds);
    }
    return crowds;
  }

 private:
  const Vec3& place(VertexId v) const { return geometry_.position(brep_.point_of(v)); }

  // By their places. As a rule counts of a few bits of these tell that there are none.
  std::vector<VertexId> maybe_crowded() const {
    std::vector<std::uint32_t> counts(std::bit_ceil(half_edges_.size()));
    const auto count = [&](HalfEdgeId h) -> std::uint32_t& {
      const Vec3& p = place(brep_.from(h));
      std::uint64_t key = 0;
      for (const double x : {p.x, p.y, p.z})
        key = (key ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15u;
      return counts[(key >> 32) & (counts.size() - 1)];
    };
    for (const HalfEdgeId h : half_edges_) ++count(h);
    std::vector<VertexId> maybe;
    for (const HalfEdgeId h : half_edges_)
      if (count(h) >= least_) maybe.push_back(brep_.from(h));
    std::ranges::sort(maybe, {}, [&](VertexId v) {
      const Vec3& p = place(v);
      return std::tuple(p.x, p.y, p.z, v);
    });
    return maybe;
  }

  // Of corners at one rounded place, those in the point of the first one.
  void add(std::span<const VertexId> corners, std::vector<CrowdedCorners::Crowd>& crowds) const {
    CrowdedCorners::Crowd crowd;
    std::size_t count = 0;
    for (const VertexId v : corners) {
      if (crowd.empty() || v != crowd.back()) {
        if (!kernel_.same_point(brep_.point_of(v), brep_.point_of(corners[0]))) continue;
        crowd.push_back(v);
      }
      ++count;
    }
    if (count >= least_) crowds.push_back(std::move(crowd));
  }

  const Kernel& kernel_;
  const Brep& brep_;
  const Geometry& geometry_;
  std::span<const HalfEdgeId> half_edges_;
  std::size_t least_;
};

std::vector<VertexId> met_of(const Patch& patch, const std::vector<VertexId>& vertices) {
  const VertexId first = patch.tested(vertices[0]);
  const auto is_first = [&](VertexId v) { return patch.tested(v) == first; };
  return std::ranges::all_of(vertices, is_first) ? std::vector{vertices[0]} : vertices;
}

std::vector<HalfEdgeId> speakers(const Patch& patch, std::span<const HalfEdgeId> leaving,
                                 const std::vector<VertexId>& vertices) {
  const Brep& brep = patch.brep;
  std::vector<HalfEdgeId> speak;
  for (const VertexId v : vertices)
    if (patch.tested(v) == v && patch.owner(v) == brep.face_of(leaving[0]))
      speak.push_back(brep.vertex_half_edge[v]);
  std::vector<std::pair<VertexId, HalfEdgeId>> by_tested;
  for (const HalfEdgeId h : leaving) by_tested.push_back({patch.tested(brep.from(h)), h});
  std::sort(by_tested.begin(), by_tested.end());
  for (std::size_t i = 0; i < by_tested.size(); ++i)
    if (i == 0 || by_tested[i].first != by_tested[i - 1].first)
      speak.push_back(by_tested[i].second);
  return speak;
}

// Of vertices on a crowded line (near/crowded_lines.h). Whichever face has one of them tests it.
void test_one_for_all(Patch& patch, const std::vector<CrowdedCorners::Crowd>& crowds) {
  for (const CrowdedCorners::Crowd& crowd : crowds)
    if (patch.on_crowded_line[crowd[0]] != 0)
      for (const VertexId v : crowd) patch.tested.set(v, crowd[0]);
}

}  // namespace

CrowdedCorners::CrowdedCorners(const Kernel& kernel, const Patch& patch, const Geometry& geometry,
                               std::span<const HalfEdgeId> half_edges,
                               const std::vector<Crowd>& crowds) {
  const Brep& brep = patch.brep;
  const auto is_in = [](VertexId v, const Crowd& crowd) {
    return std::ranges::binary_search(crowd, v);
  };
  for (const Crowd& crowd : crowds) {
    std::vector<HalfEdgeId> leaving, all;
    for (const HalfEdgeId h : half_edges) {
      const bool leaves = is_in(brep.from(h), crowd);
      if (leaves) leaving.push_back(h);
      if (leaves || is_in(brep.to(h), crowd)) all.push_back(h);
    }
    PieceTree tree = tree_of_edges(patch, geometry, all);
    std::vector<HalfEdgeId> speak = speakers(patch, leaving, crowd);
    const PointId point = brep.point_of(crowd[0]);
    fans_.push_back({point, geometry.position(point), CornerFan(kernel, patch, leaving), crowd,
                     met_of(patch, crowd), std::move(speak), std::move(all), std::move(tree)});
  }
  for (const HalfEdgeId h : half_edges)
    if (!at(brep.from(h)) && !at(brep.to(h))) others_.push_back(h);
  if (!others_.empty()) tree_of_others_.emplace(tree_of_edges(patch, geometry, others_));
}

const CrowdedCorners::Fan* CrowdedCorners::at(VertexId v) const {
  const auto fan = std::ranges::find_if(
      fans_, [&](const Fan& f) { return std::ranges::binary_search(f.vertices, v); });
  return fan == fans_.end() ? nullptr : &*fan;
}

// Nothing is asked of the edges that begin there, as none of them comes there again.
bool CrowdedCorners::touch(const Kernel& kernel, const Patch& patch, PlaneId plane,
                           const Probe& point, std::vector<Entity>& found) const {
  RayCount count(kernel, patch, plane, point, found);
  const Vec3& at = point.position();
  const auto is_at = [&](const Fan& fan) { return fan.place == at && count.touches(fan.point); };
  if (std::ranges::none_of(fans_, is_at)) return false;
  const PieceTree place(std::span(&at, 1));
  const auto add = [&](HalfEdgeId h) { count.add(h); };
  for (const Fan& fan : fans_)
    if (!is_at(fan)) query(fan, place, add);
  query_others(place, add);
  for (const Fan& fan : fans_)
    if (is_at(fan)) found.insert(found.end(), fan.met.begin(), fan.met.end());
  return true;
}

void find_crowded_corners(Patch& patch, const Geometry& geometry, const Kernel& kernel) {
  for (std::uint32_t f = 0; f < patch.outlines.size(); ++f) {
    if (!patch.outlines[f]) continue;
    const std::vector<HalfEdgeId>& half_edges = patch.outlines[f]->half_edges;
    const auto crowds = CrowdFinder(kernel, patch.brep, geometry, half_edges).run();
    if (crowds.empty()) continue;
    if (!patch.on_crowded_line.empty()) test_one_for_all(patch, crowds);
    patch.crowded.push_back({FaceId(f), std::make_shared<const CrowdedCorners>(
                                            kernel, patch, geometry, half_edges, crowds)});
  }
}

}  // namespace sectile
