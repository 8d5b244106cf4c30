#include "import/triangles/chunk_borders.h"

#include <atomic>
#include <functional>

#include "geometry/four_points.h"
#include "import/triangles/chunk_reader.h"
#include "parallel/parallel.h"
#include "search/equal_elements.h"

namespace sectile {
namespace {

template <class Body>
void for_each(std::uint32_t count, std::uint32_t step, const Body& body) {
  parallel::loop(parallel::Range<std::uint32_t>(0, count, step), [&](const auto& range) {
    for (std::uint32_t i = range.begin(); i < range.end(); ++i) body(i);
  });
}
template <class Body>
void for_each_border(const ChunkBorders& borders, const Body& body) {
  for_each(borders.count(), 2048, body);
}

class BorderMatcher {
 public:
  explicit BorderMatcher(TriangleMesh& mesh) : mesh_(mesh), borders_(mesh.borders) {}

  bool run() {
    collect();
    if (!match()) return false;
    find_flat_edges();
    return true;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  // Lines of borders first, then those of chords.
  void collect() {
    std::uint32_t borders = 0, chords = 0;
    std::vector<std::uint32_t> first_chord;
    borders_.begin.assign(1, 0);
    for (const TriangleChunk& chunk : mesh_.chunks) {
      first_chord.push_back(chords);
      chords += static_cast<std::uint32_t>(chunk.chords.size());
      borders_.begin.push_back(borders += static_cast<std::uint32_t>(chunk.borders.size()));
    }
    borders_.all.resize(borders);
    borders_.own.resize(borders);
    borders_.beyond.resize(borders);
    lines_.resize(borders + std::size_t(chords));
    for_each(mesh_.chunk_count(), 32, [&](std::uint32_t c) {
      const TriangleChunk& chunk = mesh_.chunks[c];
      std::ranges::copy(chunk.chords, lines_.begin() + borders + first_chord[c]);
      for (std::uint32_t number = 0; number < chunk.borders.size(); ++number) {
        const std::uint32_t b = borders_.at({c, number});
        borders_.all[b] = chunk.borders[number];
        borders_.own[b] = {c, number};
        borders_.beyond[b].chunk = none;
        lines_[b] = line_between(borders_.all[b].from, borders_.all[b].to);
      }
    });
  }

  bool match() {
    std::atomic<bool> plain = true;
    const auto refuse = [&] { plain.store(false, std::memory_order_relaxed); };
    for_each_equal(
        lines_.size(),
        [&](std::uint32_t i) {
          return static_cast<std::uint32_t>(lines_[i] * 0x9E3779B97F4A7C15u >> 32);
        },
        [&](std::uint32_t i, std::uint32_t j) { return lines_[i] == lines_[j]; },
        [&](std::uint32_t first, std::uint32_t i) {
          if (i >= borders_.count() || borders_.beyond[first].chunk != none) return refuse();
          borders_.beyond[first] = borders_.own[i];
          borders_.beyond[i] = borders_.own[first];
        });
    if (!plain) return false;
    for_each_border(borders_, [&](std::uint32_t b) {
      if (borders_.beyond[b].chunk == none || beyond(b).from != borders_.all[b].to) refuse();
    });
    return plain;
  }
  const ChunkBorder& beyond(std::uint32_t b) const {
    return borders_.all[borders_.at(borders_.beyond[b])];
  }

  void find_flat_edges() {
    std::vector<std::uint8_t> flat(borders_.count(), 0);
    for_each_border(borders_, [&](std::uint32_t b) {
      flat[b] = b < borders_.at(borders_.beyond[b]) && is_flat(b);
    });
    for (std::uint32_t b = 0; b < flat.size(); ++b)
      if (flat[b] != 0)
        for (const std::uint32_t side : {b, borders_.at(borders_.beyond[b])})
          borders_.flat.push_back(mesh_.corner_of(side) / 3);
  }
  bool is_flat(std::uint32_t b) const {
    const ChunkBorder& border = borders_.all[b];
    return in_one_plane(position(border.from), position(border.to), position(border.apex),
                        position(beyond(b).apex));
  }
  Vec3 position(std::uint32_t point) const { return mesh_.position(PointId(point)); }

  TriangleMesh& mesh_;
  ChunkBorders& borders_;
  UnsetVector<std::uint64_t> lines_;
};

}  // namespace

bool match_borders(TriangleMesh& mesh) {
  return BorderMatcher(mesh).run();
}

// A point of several chunks is marked with a border that leaves it. From border to border around
// all points one comes through all borders, unless several cycles go around one; where a point is
// within one chunk and in another one, too, a mark is missing.
bool has_plain_points(const TriangleMesh& mesh, std::span<std::uint32_t> marks) {
  struct Count {
    std::size_t points_within = 0, borders = 0;
    Count operator+(const Count& other) const {
      return {points_within + other.points_within, borders + other.borders};
    }
    bool operator==(const Count&) const = default;
  };
  const ChunkBorders& borders = mesh.borders;
  for_each_border(borders, [&](std::uint32_t b) {
    std::atomic_ref(marks[borders.all[b].from]).store(b, std::memory_order_relaxed);
  });
  const auto next_around = [&](std::uint32_t b) {
    const std::uint32_t last = borders.at({borders.own[b].chunk, borders.all[b].around});
    return borders.at(borders.beyond[last]);
  };
  const Count met = parallel::reduce(
      parallel::Range<std::size_t>(0, marks.size(), 4096), Count(),
      [&](const auto& range, Count sum) {
        for (std::size_t p = range.begin(); p < range.end(); ++p) {
          if (marks[p] == ChunkReader::within) ++sum.points_within;
          if (marks[p] >= borders.count()) continue;
          std::uint32_t b = marks[p];
          do {
            ++sum.borders;
            b = next_around(b);
          } while (b != marks[p]);
        }
        return sum;
      },
      std::plus<>());
  Count expected{0, borders.count()};
  for (const TriangleChunk& chunk : mesh.chunks) expected.points_within += chunk.points_within;
  return met == expected;
}

}  // namespace sectile
