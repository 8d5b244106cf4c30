#include "needles.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace sectile::bench {
namespace {

// The rings of a pipe, and what spans them.
class PipeMesh {
 public:
  explicit PipeMesh(const TwistedPipe& pipe) : pipe_(pipe) {
    add_ring(pipe.outer_radius, -1);
    add_ring(pipe.outer_radius, 1);
    add_ring(pipe.inner_radius, -1);
    add_ring(pipe.inner_radius, 1);
    add_band(0, 1);
    add_band(3, 2);
    add_band(1, 3);
    add_band(2, 0);
  }

  PolygonMesh mesh;

 private:
  void add_ring(double radius, double z) {
    for (std::uint32_t i = 0; i < pipe_.needles; ++i) {
      const double angle = 2 * std::numbers::pi * i / pipe_.needles + z * pipe_.twist / 2;
      mesh.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  }

  std::uint32_t corner(std::uint32_t ring, std::uint32_t i) const {
    return ring * pipe_.needles + i % pipe_.needles;
  }
  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh.face_sizes.push_back(3);
    mesh.indices.insert(mesh.indices.end(), {a, b, c});
  }
  void add_band(std::uint32_t lower, std::uint32_t upper) {
    for (std::uint32_t i = 0; i < pipe_.needles; ++i) {
      add_triangle(corner(lower, i), corner(lower, i + 1), corner(upper, i));
      add_triangle(corner(lower, i + 1), corner(upper, i + 1), corner(upper, i));
    }
  }

  const TwistedPipe& pipe_;
};

}  // namespace

PolygonMesh twisted_pipe(const TwistedPipe& pipe) {
  // Between two needles a wall is nearer to the axis than at them, by less than this share.
  const double dent = std::numbers::pi / pipe.needles;
  if (pipe.needles < 8 || std::abs(pipe.twist) > 2.5 ||
      !(pipe.inner_radius < pipe.outer_radius * (1 - 8 * dent * dent)))
    throw std::invalid_argument("a twisted pipe needs a thicker wall or more needles");
  return PipeMesh(pipe).mesh;
}

}  // namespace sectile::bench
