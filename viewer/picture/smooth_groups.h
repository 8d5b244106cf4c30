// Which corners of a surface share a normal: those that meet at a vertex across smooth edges.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <numeric>
#include <vector>

namespace sectile::viewer {

class SmoothGroups {
 public:
  explicit SmoothGroups(std::size_t corners) : parents_(corners), sums_(corners, glm::dvec3(0)) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  void join(std::uint32_t a, std::uint32_t b) { parents_[root(a)] = root(b); }

  /// To be called for each corner once all are joined, before the first normal_at().
  void add(std::uint32_t corner, const glm::dvec3& weighted_normal) {
    sums_[root(corner)] += weighted_normal;
  }
  /// `own` where the others say nothing.
  glm::dvec3 normal_at(std::uint32_t corner, const glm::dvec3& own) {
    const glm::dvec3& sum = sums_[root(corner)];
    const double length = glm::length(sum);
    return length > 1e-12 ? sum / length : own;
  }

 private:
  std::uint32_t root(std::uint32_t corner) {
    while (parents_[corner] != corner) corner = parents_[corner] = parents_[parents_[corner]];
    return corner;
  }

  std::vector<std::uint32_t> parents_;
  std::vector<glm::dvec3> sums_;
};

}  // namespace sectile::viewer
