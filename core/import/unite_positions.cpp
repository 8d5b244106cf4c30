#include "import/unite_positions.h"

#include <atomic>
#include <bit>

#include "parallel/parallel.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;

// Open addressing, in which many threads enter positions at a time. Each slot ends with the first
// of the positions that are equal, whoever came first.
class PositionTable {
 public:
  explicit PositionTable(std::span<const Vec3> positions)
      : positions_(positions), slots_(std::bit_ceil(2 * positions.size() + 1), none) {}

  /// The slot of all positions that are equal to this one.
  std::size_t add(std::uint32_t i) {
    for (std::size_t at = hash(positions_[i]) & mask();; at = (at + 1) & mask()) {
      std::atomic_ref slot(slots_[at]);
      std::uint32_t known = slot.load(std::memory_order_relaxed);
      if (known == none && slot.compare_exchange_strong(known, i, std::memory_order_relaxed))
        return at;
      if (!(positions_[known] == positions_[i])) continue;
      while (i < known && !slot.compare_exchange_weak(known, i, std::memory_order_relaxed)) {
      }
      return at;
    }
  }
  /// The first position of a slot, once all were added.
  std::uint32_t first(std::size_t slot) const { return slots_[slot]; }

 private:
  std::size_t mask() const { return slots_.size() - 1; }
  static std::size_t hash(const Vec3& p) {
    std::uint64_t h = 0;
    for (const double v : {p.x, p.y, p.z}) {
      h = (h ^ std::bit_cast<std::uint64_t>(v + 0.0)) * 0x9E3779B97F4A7C15u;  // -0 as 0
      h ^= h >> 32;
    }
    return h;
  }

  std::span<const Vec3> positions_;
  std::vector<std::uint32_t> slots_;
};

template <class Body>
void for_each(std::size_t count, const Body& body) {
  parallel::loop(tbb::blocked_range<std::uint32_t>(0, static_cast<std::uint32_t>(count), 4096),
                 [&](const auto& range) {
                   for (std::uint32_t i = range.begin(); i < range.end(); ++i) body(i);
                 });
}

}  // namespace

std::vector<PointId> unite_positions(std::span<const Vec3> positions, Geometry& geometry,
                                     std::vector<std::uint32_t>& input_vertex) {
  PositionTable table(positions);
  std::vector<std::uint32_t> first(positions.size());  // at first: the slot
  for_each(positions.size(),
           [&](std::uint32_t i) { first[i] = static_cast<std::uint32_t>(table.add(i)); });
  for_each(positions.size(), [&](std::uint32_t i) { first[i] = table.first(first[i]); });
  std::vector<PointId> points(positions.size());
  input_vertex.reserve(positions.size());
  for (std::uint32_t i = 0; i < first.size(); ++i) {
    if (first[i] == i) {
      points[i] = PointId(input_vertex.size());
      input_vertex.push_back(i);
    } else {
      points[i] = points[first[i]];
    }
  }
  geometry.positions.resize(input_vertex.size());
  geometry.construct.assign(input_vertex.size(), Geometry::explicit_point);
  for_each(input_vertex.size(), [&](std::uint32_t p) {
    const Vec3& at = positions[input_vertex[p]];
    geometry.positions[PointId(p)] = {at.x + 0.0, at.y + 0.0, at.z + 0.0};
  });
  return points;
}

}  // namespace sectile
