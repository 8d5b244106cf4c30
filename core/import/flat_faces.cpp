// Zero-area faces. All corners of such a face lie on a line, so its edges cancel each other if each
// is taken piece by piece; the faces on the other sides of its edges only have to know the pieces.
#include <algorithm>
#include <map>

#include "import/polygons.h"

namespace sectile {
namespace {

using Edge = std::pair<PointId, PointId>;  // ascending

Edge edge_between(PointId a, PointId b) {
  return a < b ? Edge{a, b} : Edge{b, a};
}

bool is_flat(const Polygons& polygons, const Kernel& kernel, std::size_t f) {
  const auto loop = polygons.loop(polygons.first_loop(f));
  if (polygons.face_end[f] - polygons.first_loop(f) > 1) return false;
  for (std::size_t i = 2; i < loop.size(); ++i)
    if (!collinear(kernel, loop[0], loop[1], loop[i])) return false;
  return true;
}

// Ascending along their line.
void sort_along(const Kernel& kernel, std::vector<PointId>& points) {
  std::sort(points.begin(), points.end(), [&](PointId p, PointId q) {
    for (int axis = 0; axis < 3; ++axis)
      if (const Sign s = kernel.compare(p, q, axis); s != Sign::zero) return s == Sign::positive;
    return false;
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
}

// The points of flat faces within their edges.
std::map<Edge, std::vector<PointId>> edge_pieces(const Polygons& polygons, const Kernel& kernel,
                                                 const std::vector<std::uint32_t>& flat) {
  std::map<Edge, std::vector<PointId>> pieces;
  for (const std::uint32_t f : flat) {
    const auto loop = polygons.loop(polygons.first_loop(f));
    std::vector<PointId> line(loop.begin(), loop.end());
    sort_along(kernel, line);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      auto a = std::find(line.begin(), line.end(), loop[i]);
      auto b = std::find(line.begin(), line.end(), loop[i + 1 < loop.size() ? i + 1 : 0]);
      if (b < a) std::swap(a, b);
      if (b - a < 2) continue;
      auto& piece = pieces[edge_between(*a, *b)];
      piece.insert(piece.end(), a + 1, b);
    }
  }
  for (auto& [edge, points] : pieces) sort_along(kernel, points);
  return pieces;
}

Polygons with_pieces(const Polygons& polygons, const Kernel& kernel,
                     const std::map<Edge, std::vector<PointId>>& pieces) {
  Polygons refined;
  std::vector<PointId> loop;
  for (std::size_t f = 0; f < polygons.face_count(); ++f) {
    for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l) {
      loop.clear();
      const auto corners = polygons.loop(l);
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const PointId a = corners[i], b = corners[i + 1 < corners.size() ? i + 1 : 0];
        loop.push_back(a);
        const auto piece = pieces.find(edge_between(a, b));
        if (piece == pieces.end()) continue;
        std::vector<PointId> ends{a, b};
        sort_along(kernel, ends);
        if (ends[0] == a)
          loop.insert(loop.end(), piece->second.begin(), piece->second.end());
        else
          loop.insert(loop.end(), piece->second.rbegin(), piece->second.rend());
      }
      refined.add_loop(loop);
    }
    refined.end_face(polygons.source[f]);
  }
  return refined;
}

}  // namespace

bool collinear(const Kernel& kernel, PointId a, PointId b, PointId c) {
  for (int axis = 0; axis < 3; ++axis)
    if (kernel.turn(a, b, c, axis) != Sign::zero) return false;
  return true;
}

void remove_flat_faces(Polygons& polygons, const Kernel& kernel) {
  std::vector<std::uint32_t> flat;
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f)
    if (is_flat(polygons, kernel, f)) flat.push_back(f);
  if (flat.empty()) return;
  // A piece may again be an edge of another flat face.
  for (auto pieces = edge_pieces(polygons, kernel, flat); !pieces.empty();
       pieces = edge_pieces(polygons, kernel, flat))
    polygons = with_pieces(polygons, kernel, pieces);
  Polygons kept;
  auto next_flat = flat.begin();
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f) {
    if (next_flat != flat.end() && *next_flat == f) {
      ++next_flat;
      continue;
    }
    for (std::uint32_t l = polygons.first_loop(f); l < polygons.face_end[f]; ++l)
      kept.add_loop(polygons.loop(l));
    kept.end_face(polygons.source[f]);
  }
  polygons = std::move(kept);
}

}  // namespace sectile
