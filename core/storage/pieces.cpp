#include "storage/pieces.h"

#include <algorithm>
#include <utility>

#include "numbers/disjoint_sets.h"

namespace sectile {

Pieces::Pieces(const Brep& brep, std::uint32_t border_count) {
  DisjointSets sets(brep.face_count());
  for (std::size_t e = border_count; e < brep.edge_count(); ++e)
    sets.unite(brep.face_of(Brep::half_edge(EdgeId(e), 0)).value(),
               brep.face_of(Brep::half_edge(EdgeId(e), 1)).value());
  auto [of_face, count] = std::move(sets).numbered();
  set(std::move(of_face), count);
}

Pieces::Pieces(const CompactTriangles& triangles) {
  if (triangles.piece_count > 0) {
    count_ = triangles.piece_count;
    of_face_.assign(triangles.piece.begin(), triangles.piece.end());
    return;
  }
  std::vector<std::uint16_t> face(triangles.half_edge_count);
  for (std::size_t t = 0; t < triangles.triangles.size(); ++t)
    for (const std::uint16_t h : triangles.triangles[t].half_edge)
      face[h] = static_cast<std::uint16_t>(t);
  DisjointSets sets(triangles.triangles.size());
  for (std::size_t h = 2 * triangles.border.size(); h < face.size(); h += 2)
    sets.unite(face[h], face[h + 1]);
  auto [of_face, count] = std::move(sets).numbered();
  set(std::move(of_face), count);
}

void Pieces::set(std::vector<std::uint32_t> of_face, std::uint32_t count) {
  count_ = count;
  if (count > 1) of_face_ = std::move(of_face);
}

FaceId Pieces::face_of(std::uint32_t piece) const {
  if (count_ == 1) return FaceId(0);
  return FaceId(static_cast<std::size_t>(std::ranges::find(of_face_, piece) - of_face_.begin()));
}

}  // namespace sectile
