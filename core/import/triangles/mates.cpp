#include "import/triangles/mates.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

// A half-edge whose other half is not in its chunk.
struct Open {
  std::uint64_t line;  // its lower and its higher point
  std::uint32_t corner;
  friend bool operator<(const Open& a, const Open& b) {
    return a.line != b.line ? a.line < b.line : a.corner < b.corner;
  }
};

std::uint64_t line_of(const TriangleMesh& mesh, std::uint32_t corner) {
  const auto [low, high] = std::minmax({mesh.from(corner).value(), mesh.to(corner).value()});
  return std::uint64_t(low) << 32 | high;
}

// The half-edges of one chunk that wait for their other halves, by the vertices that they leave.
// All are numbered within the chunk.
class Waiting {
 public:
  void clear(std::size_t vertices) { std::fill_n(first_.begin(), vertices, nothing); }
  void add(std::uint16_t half_edge, std::uint16_t from, std::uint16_t to) {
    to_[half_edge] = to;
    after_[half_edge] = first_[from];
    first_[from] = half_edge;
  }
  /// Takes away one that runs from one vertex to another; nothing if there is none.
  std::uint16_t take(std::uint16_t from, std::uint16_t to) {
    for (std::uint16_t* at = &first_[from]; *at != nothing; at = &after_[*at])
      if (to_[*at] == to) {
        const std::uint16_t found = *at;
        *at = after_[found];
        return found;
      }
    return nothing;
  }
  static constexpr std::uint16_t nothing = 0xFFFF;

 private:
  std::array<std::uint16_t, std::size_t(3) * TriangleMesh::most_of_a_chunk> first_, after_, to_;
};

class MateFinder {
 public:
  explicit MateFinder(TriangleMesh& mesh)
      : mesh_(mesh), open_(mesh.chunk_count()), pieces_(mesh.chunk_count()) {
    mesh_.mate.assign(mesh_.corners.size(), none);
  }

  bool run() {
    match_within_chunks();
    return match_between_chunks();
  }

  /// Once all mates are found.
  ShellOfTriangle shells() const {
    DisjointSets sets(mesh_.triangle_count());
    for (std::size_t i = 0; i < all_open_.size(); i += 2)
      sets.unite(piece(all_open_[i].corner), piece(all_open_[i + 1].corner));
    if (is_one(sets)) return {};
    for (std::uint32_t c = 0; c < mesh_.chunk_count(); ++c)
      for (std::uint32_t t = mesh_.chunk_begin(c); t < mesh_.chunk_end(c); ++t)
        sets.unite(t, mesh_.chunk_begin(c) + first(pieces_[c], place_in_chunk(3 * t, c)));
    auto [of, count] = std::move(sets).numbered();
    return {count, std::move(of)};
  }

 private:
  // The triangles of a chunk that hang together over its edges: of place i in the chunk, the least
  // one with which it does.
  using Pieces = std::array<std::uint8_t, TriangleMesh::most_of_a_chunk>;
  static_assert(TriangleMesh::most_of_a_chunk <= 256);

  void match_within_chunks() {
    parallel::loop(tbb::blocked_range<std::uint32_t>(0, mesh_.chunk_count(), 8),
                   [&](const auto& range) {
                     Waiting waiting;
                     for (std::uint32_t c = range.begin(); c < range.end(); ++c)
                       match_within(c, waiting);
                   });
  }

  void match_within(std::uint32_t chunk, Waiting& waiting) {
    waiting.clear(mesh_.vertex_count[chunk]);
    Pieces& pieces = pieces_[chunk];
    for (std::size_t i = 0; i < pieces.size(); ++i) pieces[i] = static_cast<std::uint8_t>(i);
    const std::uint32_t begin = 3 * mesh_.chunk_begin(chunk), end = 3 * mesh_.chunk_end(chunk);
    std::size_t open = end - begin;
    for (std::uint32_t corner = begin; corner < end; ++corner) {
      const std::uint16_t from = mesh_.vertex[corner],
                          to = mesh_.vertex[TriangleMesh::next(corner)];
      const std::uint16_t other = waiting.take(to, from);
      if (other == Waiting::nothing) {
        waiting.add(static_cast<std::uint16_t>(corner - begin), from, to);
        continue;
      }
      pair(begin + other, corner);
      unite(pieces, static_cast<std::uint8_t>(other / 3), place_in_chunk(corner, chunk));
      open -= 2;
    }
    open_[chunk].reserve(open);
    for (std::uint32_t corner = begin; corner < end; ++corner)
      if (mesh_.mate[corner] == none) open_[chunk].push_back({line_of(mesh_, corner), corner});
  }

  std::uint8_t place_in_chunk(std::uint32_t corner, std::uint32_t chunk) const {
    return static_cast<std::uint8_t>(corner / 3 - mesh_.chunk_begin(chunk));
  }
  static std::uint8_t first(const Pieces& pieces, std::uint8_t i) {
    while (pieces[i] != i) i = pieces[i];
    return i;
  }
  static void unite(Pieces& pieces, std::uint8_t i, std::uint8_t j) {
    const auto [low, high] = std::minmax({first(pieces, i), first(pieces, j)});
    pieces[high] = low;
  }

  void pair(std::uint32_t a, std::uint32_t b) {
    mesh_.mate[a] = b;
    mesh_.mate[b] = a;
  }

  bool match_between_chunks() {
    std::size_t count = 0;
    for (const auto& some : open_) count += some.size();
    all_open_.reserve(count);
    for (const auto& some : open_) all_open_.insert(all_open_.end(), some.begin(), some.end());
    open_ = {};
    if (count % 2 != 0) return false;
    parallel::sort(all_open_.begin(), all_open_.end());
    parallel::loop(tbb::blocked_range<std::size_t>(0, count / 2, 4096), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const Open &a = all_open_[2 * i], &b = all_open_[2 * i + 1];
        if (a.line != b.line || mesh_.from(a.corner) == mesh_.from(b.corner))
          is_plain_ = false;
        else
          pair(a.corner, b.corner);
      }
    });
    return is_plain_;
  }

  bool is_one(DisjointSets& sets) const {
    for (std::uint32_t c = 0; c < mesh_.chunk_count(); ++c)
      for (std::uint32_t t = mesh_.chunk_begin(c); t < mesh_.chunk_end(c); ++t)
        if (pieces_[c][t - mesh_.chunk_begin(c)] == t - mesh_.chunk_begin(c) && sets.first(t) != 0)
          return false;
    return true;
  }

  // A piece goes by its least triangle.
  std::uint32_t piece(std::uint32_t corner) const {
    const std::uint32_t chunk = mesh_.chunk_of(corner);
    return mesh_.chunk_begin(chunk) + first(pieces_[chunk], place_in_chunk(corner, chunk));
  }

  TriangleMesh& mesh_;
  std::vector<std::vector<Open>> open_;  // per chunk
  std::vector<Open> all_open_;
  std::vector<Pieces> pieces_;  // per chunk
  std::atomic<bool> is_plain_ = true;
};

// One cycle of triangles around each point, in which no other point is met twice: then no edge has
// more than two triangles, wherever these are.
class Umbrellas {
 public:
  explicit Umbrellas(const TriangleMesh& mesh)
      : mesh_(mesh), some_corner_(mesh.geometry->positions.size(), none) {}

  bool all_plain() {
    const auto corner_count = static_cast<std::uint32_t>(mesh_.corners.size());
    parallel::loop(tbb::blocked_range<std::uint32_t>(0, corner_count, 16384),
                   [&](const auto& range) {
                     for (std::uint32_t i = range.begin(); i < range.end(); ++i) note(i);
                   });
    const std::size_t met = parallel::reduce(
        tbb::blocked_range<std::size_t>(0, some_corner_.size(), 4096), std::size_t(0),
        [&](const auto& range, std::size_t sum) {
          std::vector<PointId> around;
          for (std::size_t p = range.begin(); p < range.end(); ++p)
            if (some_corner_[p] != none) sum += size_of_cycle(some_corner_[p], around);
          return sum;
        },
        std::plus<>());
    return met == corner_count;
  }

 private:
  // Which one is all the same.
  void note(std::uint32_t corner) {
    std::atomic_ref(some_corner_[mesh_.from(corner).value()])
        .store(corner, std::memory_order_relaxed);
  }

  // Nothing where a point is met twice.
  std::size_t size_of_cycle(std::uint32_t first, std::vector<PointId>& around) const {
    around.clear();
    std::uint32_t corner = first;
    do {
      around.push_back(mesh_.to(corner));
      corner = mesh_.mate[TriangleMesh::prev(corner)];
    } while (corner != first);
    return any_twice(around) ? 0 : around.size();
  }
  static bool any_twice(std::vector<PointId>& points) {
    if (points.size() > 16) {
      std::sort(points.begin(), points.end());
      return std::adjacent_find(points.begin(), points.end()) != points.end();
    }
    for (std::size_t i = 1; i < points.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (points[i] == points[j]) return true;
    return false;
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> some_corner_;  // per point
};

}  // namespace

std::optional<ShellOfTriangle> find_mates(TriangleMesh& mesh) {
  MateFinder finder(mesh);
  if (!finder.run()) return {};
  ShellOfTriangle shells;
  bool all_plain = false;
  parallel::invoke([&] { shells = finder.shells(); },
                   [&] { all_plain = Umbrellas(mesh).all_plain(); });
  if (!all_plain) return {};
  return shells;
}

}  // namespace sectile
