#include <cmath>

#include "import/soup.h"
#include "primitives/arguments.h"
#include "primitives/circle.h"

namespace sectile {

namespace {

// Ring j = 0 is the north pole, ring j = rings the south pole; the corners of the rings between
// stand one ring after another, from the north.
class SphereMesh {
 public:
  SphereMesh(const Vec3& centre, double radius, std::uint32_t segments, std::uint32_t rings)
      : segments_(segments), rings_(rings) {
    const std::size_t triangles = 2 * std::size_t{segments} * (rings - 1);
    mesh_.positions.reserve(std::size_t{segments} * (rings - 1) + 2);
    mesh_.indices.reserve(3 * triangles);
    add_positions(centre, radius);
    for (std::uint32_t j = 0; j < rings; ++j) add_band(j);
    mesh_.face_sizes.assign(triangles, 3);
  }

  PolygonMesh take() { return std::move(mesh_); }

 private:
  void add_positions(const Vec3& centre, double radius) {
    std::vector<Vec2> circle;
    for (std::uint32_t k = 0; k < segments_; ++k) circle.push_back(circle_point(k, segments_));
    for (std::uint32_t j = 1; j < rings_; ++j) {
      const Vec2 latitude = circle_point(j, 2 * std::uint64_t{rings_});
      const double height = radius * latitude.x, width = radius * latitude.y;
      for (const Vec2& direction : circle)
        mesh_.positions.push_back(
            {centre.x + width * direction.x, centre.y + width * direction.y, centre.z + height});
    }
    mesh_.positions.push_back({centre.x, centre.y, centre.z + radius});
    mesh_.positions.push_back({centre.x, centre.y, centre.z - radius});
  }

  std::uint32_t corner(std::uint32_t ring, std::uint32_t k) const {
    if (ring == 0) return (rings_ - 1) * segments_;
    if (ring == rings_) return (rings_ - 1) * segments_ + 1;
    return (ring - 1) * segments_ + (k == segments_ ? 0 : k);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    mesh_.indices.insert(mesh_.indices.end(), {a, b, c});
  }

  // Every diagonal leaves the ring nearer to the equator, at the first corner in even octants and
  // at the second corner in odd ones, so that mirror images of the sphere are the sphere.
  void add_band(std::uint32_t north) {
    for (std::uint32_t k = 0; k < segments_; ++k) {
      const std::uint32_t a = corner(north + 1, k), b = corner(north + 1, k + 1);
      const std::uint32_t c = corner(north, k + 1), d = corner(north, k);
      if (c == d) {
        add_triangle(a, b, c);
      } else if (a == b) {
        add_triangle(a, c, d);
      } else if (diagonal_from_a(north, k)) {
        add_triangle(a, b, c);
        add_triangle(a, c, d);
      } else {
        add_triangle(a, b, d);
        add_triangle(b, c, d);
      }
    }
  }

  bool diagonal_from_a(std::uint32_t north, std::uint64_t k) const {
    const bool south_is_wider = 2 * std::uint64_t{north} + 1 < rings_;
    const bool odd_octant = (4 * (2 * k + 1) / segments_) % 2 == 1;
    return south_is_wider != odd_octant;
  }

  std::uint32_t segments_, rings_;
  PolygonMesh mesh_;
};

}  // namespace

PolygonMesh sphere_mesh(const Vec3& centre, double radius, std::uint32_t segments,
                        std::uint32_t rings) {
  require(std::isfinite(centre.x) && std::isfinite(centre.y) && std::isfinite(centre.z),
          "The centre of the sphere must be finite.");
  require_length(radius, "radius");
  require_count(segments, 3, "segments");
  require_count(rings, 2, "rings");
  require_size(std::uint64_t{segments} * (rings - 1) + 2);
  return SphereMesh(centre, radius, segments, rings).take();
}

Solid sphere(double radius, std::uint32_t segments, std::uint32_t rings) {
  return Solid(import_mesh(sphere_mesh({0, 0, 0}, radius, segments, rings)));
}

}  // namespace sectile
