#include "import/triangles/chunk_vertices.h"

#include <array>

#include "parallel/parallel.h"
#include "parallel/scratch.h"

namespace sectile {
namespace {

// The points of one chunk with their numbers. Small enough to stay in the fastest memory.
class PointNumbers {
 public:
  void clear() {
    count_ = 0;
    if (++round_ == 0) {
      slots_.fill({});
      round_ = 1;
    }
  }
  std::uint16_t operator[](PointId point) {
    std::size_t i = point.value() * 0x9E3779B1u >> (32 - bits);
    while (slots_[i].round == round_ && slots_[i].point != point) i = (i + 1) % slots_.size();
    if (slots_[i].round != round_) slots_[i] = {point, count_++, round_};
    return slots_[i].number;
  }
  std::uint16_t count() const { return count_; }

 private:
  static constexpr int bits = 10;
  static_assert(3 * TriangleMesh::most_of_a_chunk < 1u << bits);
  struct Slot {
    PointId point;
    std::uint16_t number = 0, round = 0;
  };
  std::array<Slot, std::size_t(1) << bits> slots_{};
  std::uint16_t count_ = 0, round_ = 0;
};

}  // namespace

void number_vertices_in_chunks(TriangleMesh& mesh) {
  mesh.vertex.resize(mesh.corners.size());
  mesh.vertex_count.resize(mesh.chunk_count());
  parallel::Scratch<PointNumbers> scratch;
  parallel::loop(
      tbb::blocked_range<std::uint32_t>(0, mesh.chunk_count(), 8), [&](const auto& range) {
        scratch.lend([&](PointNumbers& numbers) {
          for (std::uint32_t c = range.begin(); c < range.end(); ++c) {
            numbers.clear();
            for (std::uint32_t i = 3 * mesh.chunk_begin(c); i < 3 * mesh.chunk_end(c); ++i)
              mesh.vertex[i] = numbers[mesh.corners[i]];
            mesh.vertex_count[c] = numbers.count();
          }
        });
      });
}

}  // namespace sectile
