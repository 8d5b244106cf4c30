#include "import/triangles/mates.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>

#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

// The half-edges whose other halves are not in their chunks, by the lines on which they lie. Many
// threads enter them at a time.
class OpenLines {
 public:
  OpenLines(const TriangleMesh& mesh, std::size_t expected)
      : mesh_(mesh), slots_(std::bit_ceil(2 * expected + 1)) {}

  /// The half-edge that waits on the line of this one, which takes its place if there is none.
  std::uint32_t take_or_add(std::uint32_t corner) {
    std::atomic_ref waiting(slot_of(corner).corner);
    std::uint32_t other = waiting.load(std::memory_order_relaxed);
    while (!waiting.compare_exchange_weak(other, other == none ? corner : none,
                                          std::memory_order_relaxed)) {
    }
    return other;
  }

 private:
  static constexpr std::uint64_t no_line = ~std::uint64_t(0);
  struct Slot {
    std::uint64_t line = no_line;
    std::uint32_t corner = none;
  };

  // Lines that are near in the mesh are near in the table, and those through one point apart. Where
  // the table is crowded, as it is when lines of some parts of the mesh only are open, they go
  // anywhere.
  Slot& slot_of(std::uint32_t corner) {
    constexpr std::size_t near = 8;
    const auto [low, high] = std::minmax({mesh_.from(corner).value(), mesh_.to(corner).value()});
    const std::uint64_t line = std::uint64_t(low) << 32 | high;
    const auto far = static_cast<std::size_t>(line * 0x9E3779B97F4A7C15u >> 32 | 1);
    std::size_t i = std::size_t(low) + 3 * std::size_t(high);
    for (std::size_t seen = 1;; i += seen++ < near ? 1 : far) {
      Slot& slot = slots_[i & (slots_.size() - 1)];
      std::uint64_t known = no_line;
      if (std::atomic_ref(slot.line).compare_exchange_strong(known, line,
                                                             std::memory_order_relaxed) ||
          known == line)
        return slot;
    }
  }

  const TriangleMesh& mesh_;
  std::vector<Slot> slots_;
};

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
    mesh_.hangs_together.resize(mesh_.chunk_count());
  }

  bool run() {
    match_within_chunks();
    return match_between_chunks();
  }

  /// Once all mates are found.
  ShellOfTriangle shells() const {
    DisjointSets sets(mesh_.triangle_count());
    for (const auto& some : open_)
      for (const std::uint32_t corner : some)
        if (corner < mesh_.mate[corner]) sets.unite(piece(corner), piece(mesh_.mate[corner]));
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
    for_each_range_of_chunks([&](const auto& range) {
      Waiting waiting;
      for (std::uint32_t c = range.begin(); c < range.end(); ++c) match_within(c, waiting);
    });
  }

  template <class Body>
  void for_each_range_of_chunks(const Body& body) {
    parallel::loop(tbb::blocked_range<std::uint32_t>(0, mesh_.chunk_count(), 8), body);
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
    mesh_.hangs_together[chunk] = all_in_first(pieces, (end - begin) / 3);
    open_[chunk].reserve(open);
    for (std::uint32_t corner = begin; corner < end; ++corner)
      if (mesh_.mate[corner] == none) open_[chunk].push_back(corner);
  }

  std::uint8_t place_in_chunk(std::uint32_t corner, std::uint32_t chunk) const {
    return static_cast<std::uint8_t>(corner / 3 - mesh_.chunk_begin(chunk));
  }
  static std::uint8_t first(const Pieces& pieces, std::uint8_t i) {
    while (pieces[i] != i) i = pieces[i];
    return i;
  }
  static bool all_in_first(const Pieces& pieces, std::size_t triangles) {
    for (std::size_t i = 1; i < triangles; ++i)
      if (pieces[i] == i) return false;
    return true;
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
    if (count % 2 != 0) return false;
    OpenLines lines(mesh_, count / 2);
    for_each_range_of_chunks([&](const auto& range) {
      for (std::uint32_t c = range.begin(); c < range.end(); ++c)
        for (const std::uint32_t corner : open_[c])
          if (const std::uint32_t other = lines.take_or_add(corner); other != none)
            pair(other, corner);
    });
    return std::ranges::all_of(open_, [&](const auto& some) {
      return std::ranges::all_of(some, [&](std::uint32_t corner) { return is_matched(corner); });
    });
  }

  bool is_matched(std::uint32_t corner) const {
    return mesh_.mate[corner] != none && mesh_.from(mesh_.mate[corner]) != mesh_.from(corner);
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
  std::vector<std::vector<std::uint32_t>> open_;  // per chunk: half-edges without a mate in it
  std::vector<Pieces> pieces_;                    // per chunk
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
