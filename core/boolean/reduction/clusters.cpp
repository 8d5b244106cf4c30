#include "boolean/reduction/clusters.h"

#include <algorithm>
#include <functional>
#include <numeric>

#include "numbers/disjoint_sets.h"
#include "search/bucket_sort.h"

namespace sectile {
namespace {

// `first`: the number of the first face of the patch.
void unite_at_vertices(const Patch& patch, std::uint32_t first, DisjointSets& sets) {
  constexpr std::uint32_t none = 0xFFFFFFFFu;
  Table<VertexId, std::uint32_t> face_at(patch.brep.vertex_count(), none);
  for (const FaceId f : patch.brep.faces()) {
    if (!patch.is_real(f)) continue;
    for_each_in_face(patch.brep, f, [&](HalfEdgeId h) {
      std::uint32_t& known = face_at[patch.brep.from(h)];
      if (known == none) known = first + f.value();
      sets.unite(known, first + f.value());
    });
  }
}

}  // namespace

Clusters::Clusters(const Workspace& w, const FacePairs& candidates) : w_(w) {
  const Patch &a = w.patch[Operand::a], &b = w.patch[Operand::b];
  if (a.on_crowded_line.empty()) return;
  const auto first_of_b = static_cast<std::uint32_t>(a.brep.face_count());
  DisjointSets sets(first_of_b + b.brep.face_count());
  unite_at_vertices(a, 0, sets);
  unite_at_vertices(b, first_of_b, sets);
  for (const auto& [f, g] : candidates) sets.unite(f.value(), first_of_b + g.value());
  const DisjointSets::Numbered numbered = std::move(sets).numbered();
  count_ = numbered.count;
  for (const FaceId f : a.brep.faces()) of_[Operand::a].add(numbered.of[f.value()]);
  for (const FaceId g : b.brep.faces()) of_[Operand::b].add(numbered.of[first_of_b + g.value()]);
}

std::uint32_t Clusters::of(Operand s, Entity entity) const {
  const Patch& patch = w_.patch[s];
  if (entity.is_face()) return of_[s][entity.face()];
  if (entity.is_edge()) return of_[s][patch.owner(entity.edge())];
  // A vertex of an open end may have a half-edge that is in no loaded face.
  FaceId face;
  for_each_around(patch.brep, patch.brep.vertex_half_edge[entity.vertex()], [&](HalfEdgeId h) {
    if (patch.is_real(patch.brep.face_of(h))) face = patch.brep.face_of(h);
  });
  return of_[s][face];
}

PlacesOfClusters::PlacesOfClusters(const Clusters& clusters, const Contacts& found,
                                   const Table<PlaceId, Vec3>& positions)
    : clusters_(clusters), positions_(positions) {
  for (const Contact& c : found.contacts) places_.push_back({clusters.of(c), c.place});
  std::ranges::sort(places_);
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  first_ = bucket_sort(
      places_, clusters.count(), [](const OfCluster& p) { return p.cluster; }, std::less<>());
  tree_.resize(clusters.count());
  std::vector<PieceTree::Edge> edges;
  for (std::uint32_t cluster = 0; cluster < clusters.count(); ++cluster) {
    edges.clear();
    for (std::uint32_t i = first_[cluster]; i < first_[cluster + 1]; ++i)
      edges.push_back({positions[places_[i].place], positions[places_[i].place]});
    if (!edges.empty()) tree_[cluster].emplace(edges);
  }
}

std::vector<std::uint32_t> PlacesOfClusters::by_cluster(
    std::span<const SegmentRecord> records) const {
  std::vector<std::uint32_t> order(records.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return clusters_.of(records[i]); });
  return order;
}

}  // namespace sectile
