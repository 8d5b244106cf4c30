#include <bit>
#include <charconv>
#include <cmath>

#include "import/polygons.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// Open addressing over positions; -0 and 0 are one coordinate.
class PositionTable {
 public:
  PositionTable(Geometry& geometry, std::size_t expected) : geometry_(geometry) {
    std::size_t size = 16;
    while (size < 2 * expected) size *= 2;
    slots_.assign(size, PointId());
    geometry.positions.reserve(expected);
    geometry.construct.reserve(expected);
  }

  PointId add(Vec3 p) {
    p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    for (std::size_t i = hash(p) & (slots_.size() - 1);; i = (i + 1) & (slots_.size() - 1)) {
      if (!slots_[i].valid()) return slots_[i] = geometry_.add_point(p);
      if (geometry_.position(slots_[i]) == p) return slots_[i];
    }
  }

 private:
  static std::size_t hash(const Vec3& p) {
    std::uint64_t h = 0;
    for (const double v : {p.x, p.y, p.z}) {
      h = (h ^ std::bit_cast<std::uint64_t>(v)) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return h;
  }

  Geometry& geometry_;
  std::vector<PointId> slots_;
};

void check_sizes(const Soup& soup) {
  std::uint64_t loops = 0, corners = 0;
  for (const std::uint32_t n : soup.face_loops) loops += n;
  for (const std::uint32_t n : soup.loop_sizes) corners += n;
  if (loops != soup.loop_sizes.size() || corners != soup.indices.size())
    throw InvalidSolid(InvalidSolid::Reason::malformed,
                       "the faces' sizes add up to " + std::to_string(corners) +
                           " corners, but there are " + std::to_string(soup.indices.size()) +
                           " indices");
}

}  // namespace

std::string in_words(const Vec3& p) {
  std::string text = "(";
  for (const double v : {p.x, p.y, p.z}) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, v).ptr;
    if (text.size() > 1) text += ", ";
    text.append(buffer, end);
  }
  return text + ")";
}

Polygons read_polygons(const Soup& soup, Geometry& geometry) {
  check_sizes(soup);
  std::vector<PointId> points(soup.positions.size());
  PositionTable table(geometry, soup.positions.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Vec3& p = soup.positions[i];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InvalidSolid(InvalidSolid::Reason::not_finite,
                         "vertex " + std::to_string(i) + " has a coordinate that is not finite",
                         no_element, i);
    points[i] = table.add(p);
  }
  Polygons polygons;
  polygons.corners.reserve(soup.indices.size());
  std::vector<PointId> loop;
  std::size_t next_loop = 0, next_corner = 0;
  for (std::uint32_t f = 0; f < soup.face_loops.size(); ++f) {
    const std::size_t loops_before = polygons.loop_end.size();
    for (std::uint32_t l = 0; l < soup.face_loops[f]; ++l) {
      loop.clear();
      for (std::uint32_t n = soup.loop_sizes[next_loop++]; n > 0; --n) {
        const std::uint32_t index = soup.indices[next_corner++];
        if (index >= points.size())
          throw InvalidSolid(InvalidSolid::Reason::index_out_of_range,
                             "face " + std::to_string(f) + " refers to vertex " +
                                 std::to_string(index) + ", but there are only " +
                                 std::to_string(points.size()),
                             f, index);
        if (loop.empty() || loop.back() != points[index]) loop.push_back(points[index]);
      }
      while (loop.size() > 1 && loop.back() == loop.front()) loop.pop_back();
      // There and back again bounds nothing.
      if (loop.size() > 2) polygons.add_loop(loop);
    }
    if (polygons.loop_end.size() > loops_before) polygons.end_face(f);
  }
  return polygons;
}

}  // namespace sectile
