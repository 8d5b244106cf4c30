
#include <algorithm>
#include <cmath>
#include <string>

#include "import/polygons.h"
#include "import/unite_positions.h"
#include "parallel/parallel.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using Reason = InvalidSolid::Reason;

std::string text(std::size_t number) {
  return std::to_string(number);
}

std::uint64_t total(std::span<const std::uint32_t> sizes) {
  std::uint64_t sum = 0;
  for (const std::uint32_t n : sizes) sum += n;
  return sum;
}

void check_sizes(const SoupView& soup) {
  if (!soup.face_loops.empty() && total(soup.face_loops) != soup.loop_sizes.size())
    throw InvalidSolid(Reason::malformed, "the faces have " + text(total(soup.face_loops)) +
                                              " loops in all, but the sizes of " +
                                              text(soup.loop_sizes.size()) + " are given");
  if (total(soup.loop_sizes) != soup.indices.size())
    throw InvalidSolid(Reason::malformed,
                       "the face sizes add up to " + text(total(soup.loop_sizes)) +
                           " corners, but there are " + text(soup.indices.size()) + " indices");
  constexpr std::size_t most = 0x7FFFFFFFu;
  if (soup.indices.size() > most || soup.positions.size() > most)
    throw InvalidSolid(Reason::malformed, "the mesh is too large: at most " + text(most) +
                                              " corners and as many vertices are possible");
}

bool is_finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

// The first number below `end` for which `wrong` holds, or end.
template <class Wrong>
std::size_t first_wrong(std::size_t end, const Wrong& wrong) {
  return parallel::reduce(
      parallel::Range<std::size_t>(0, end, 16384), end,
      [&](const auto& range, std::size_t known) {
        for (std::size_t i = range.begin(); i < range.end() && i < known; ++i)
          if (wrong(i)) return i;
        return known;
      },
      [](std::size_t a, std::size_t b) { return std::min(a, b); });
}

void check_positions(const SoupView& soup) {
  const std::size_t i = first_wrong(soup.positions.size(),
                                    [&](std::size_t k) { return !is_finite(soup.positions[k]); });
  if (i < soup.positions.size())
    throw InvalidSolid(
        Reason::not_finite,
        "vertex " + text(i) + " has a coordinate that is not a finite number; give it a place",
        no_element, static_cast<std::uint32_t>(i));
}

std::uint32_t face_of_corner(const SoupView& soup, std::size_t corner) {
  std::size_t loop = 0, end = 0;
  for (std::size_t f = 0; f < soup.face_count(); ++f)
    for (std::uint32_t l = 0; l < soup.loops_of(f); ++l)
      if ((end += soup.loop_sizes[loop++]) > corner) return static_cast<std::uint32_t>(f);
  return no_element;
}

void check_indices(const SoupView& soup) {
  const std::size_t count = soup.positions.size();
  const std::size_t i =
      first_wrong(soup.indices.size(), [&](std::size_t k) { return soup.indices[k] >= count; });
  if (i == soup.indices.size()) return;
  const std::uint32_t face = face_of_corner(soup, i), vertex = soup.indices[i];
  throw InvalidSolid(Reason::index_out_of_range,
                     "face " + text(face) + " refers to vertex " + text(vertex) +
                         ", but there are only " + text(count) + ", numbered from 0",
                     face, vertex);
}

class LoopReader {
 public:
  explicit LoopReader(std::vector<PointId>& corners) : corners_(corners), begin_(corners.size()) {}

  void add(PointId p) {
    if (size() > 0 && corners_.back() == p) return;
    if (size() > 1 && corners_.end()[-2] == p)
      corners_.pop_back();
    else
      corners_.push_back(p);
  }
  /// True if something is left of the loop.
  bool close() {
    std::size_t first = begin_;
    while (corners_.size() > first + 1) {
      if (corners_[first] == corners_.back() || corners_[first] == corners_.end()[-2])
        corners_.pop_back();
      else if (corners_[first + 1] == corners_.back())
        ++first;
      else
        break;
    }
    if (corners_.size() < first + 3) first = corners_.size();
    const auto at = [&](std::size_t i) {
      return corners_.begin() + static_cast<std::ptrdiff_t>(i);
    };
    corners_.erase(at(begin_), at(first));
    return size() > 0;
  }

 private:
  std::size_t size() const { return corners_.size() - begin_; }

  std::vector<PointId>& corners_;
  std::size_t begin_;
};

}  // namespace

void check_soup(const SoupView& soup) {
  check_sizes(soup);
  check_positions(soup);
  check_indices(soup);
}

Polygons read_polygons(const SoupView& soup, Geometry& geometry,
                       std::vector<std::uint32_t>& input_vertex) {
  check_soup(soup);
  const std::vector<PointId> points = unite_positions(soup.positions, geometry, input_vertex);
  Polygons polygons;
  polygons.corners.reserve(soup.indices.size());
  polygons.loop_end.reserve(soup.loop_sizes.size());
  polygons.face_end.reserve(soup.face_count());
  polygons.source.reserve(soup.face_count());
  std::size_t next_loop = 0, next_corner = 0;
  for (std::uint32_t f = 0; f < soup.face_count(); ++f) {
    const std::size_t loops_before = polygons.loop_end.size();
    for (std::uint32_t l = soup.loops_of(f); l > 0; --l) {
      LoopReader loop(polygons.corners);
      for (std::uint32_t n = soup.loop_sizes[next_loop++]; n > 0; --n)
        loop.add(points[soup.indices[next_corner++]]);
      if (loop.close())
        polygons.loop_end.push_back(static_cast<std::uint32_t>(polygons.corners.size()));
    }
    if (polygons.loop_end.size() > loops_before) polygons.end_face(f);
  }
  return polygons;
}

}  // namespace sectile
