#include "boolean/near/crowded_crossings.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "boolean/collect.h"

namespace sectile {
namespace {

// The loaded faces of one solid that have the points.
class FacesAtPoints {
 public:
  explicit FacesAtPoints(const Patch& patch) : patch_(patch) {}

  void add(std::uint32_t point, std::span<const FaceId> faces) {
    for (const FaceId f : faces) at_.push_back({loaded_face(patch_, f), point});
  }
  void sort() { std::ranges::sort(at_); }

  /// Calls visit(point).
  template <class Visit>
  void for_each_point_of(FaceId f, const Visit& visit) const {
    for (auto i = std::ranges::lower_bound(at_, At{f, 0}); i != at_.end() && i->first == f; ++i)
      visit(i->second);
  }
  bool has(FaceId f, std::uint32_t point) const {
    return std::ranges::binary_search(at_, At{f, point});
  }
  /// A face, and what speaks for its edges and vertices, as far as they have the point.
  void collect(FaceId f, std::uint32_t point, std::vector<FaceId>& owners) const {
    owners.assign(1, f);
    for_each_in_face(patch_.brep, f, [&](HalfEdgeId h) {
      for (const FaceId owner : {patch_.owner(Brep::edge_of(h)), patch_.owner(patch_.brep.from(h))})
        if (has(owner, point) && std::ranges::find(owners, owner) == owners.end())
          owners.push_back(owner);
    });
  }

 private:
  using At = std::pair<FaceId, std::uint32_t>;

  const Patch& patch_;
  std::vector<At> at_;
};

}  // namespace

void CrowdedCrossings::add(const Geometry& geometry, PointId point,
                           PerOperand<std::vector<FaceId>> faces) {
  crossings_.push_back({load_point(geometry, point, geometry_), std::move(faces)});
}

PerOperand<std::vector<FaceId>> CrowdedCrossings::faces() const {
  PerOperand<std::vector<FaceId>> all;
  for (const Crossing& crossing : crossings_)
    for (const Operand s : both_operands) append(all[s], crossing.faces[s]);
  return all;
}

void CrowdedCrossings::mark(Workspace& w) const {
  for (const Crossing& crossing : crossings_)
    w.crowded_points.push_back(load_point(geometry_, crossing.point, w.geometry));
  std::ranges::sort(w.crowded_points, {}, [&](PointId p) {
    const Vec3& at = w.geometry.position(p);
    return std::tuple(at.x, at.y, at.z);
  });
  w.kernel->refresh();
}

void CrowdedCrossings::add_pairs_of_owners(const Workspace& w, FacePairs& pairs) const {
  FacesAtPoints of_a(w.patch[Operand::a]), of_b(w.patch[Operand::b]);
  for (std::uint32_t i = 0; i < crossings_.size(); ++i) {
    of_a.add(i, crossings_[i].faces[Operand::a]);
    of_b.add(i, crossings_[i].faces[Operand::b]);
  }
  of_a.sort();
  of_b.sort();
  std::vector<FaceId> mine, across;
  for (std::size_t i = 0, count = pairs.size(); i < count; ++i) {
    const auto [f, g] = pairs[i];
    of_a.for_each_point_of(f, [&, f = f, g = g](std::uint32_t point) {
      if (!of_b.has(g, point)) return;
      of_a.collect(f, point, mine);
      of_b.collect(g, point, across);
      for (const FaceId owner : mine)
        for (const FaceId beyond : across)
          if (owner != f || beyond != g) pairs.push_back({owner, beyond});
    });
  }
}

}  // namespace sectile
