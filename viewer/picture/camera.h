// The camera: orbits around a target, z is up. Angles in radians, lengths in the scene's unit.
#pragma once

#include <glm/glm.hpp>

namespace sectile::viewer {

/// A half-line in world coordinates; `direction` has length one.
struct Ray {
  glm::dvec3 origin{0}, direction{0, 0, -1};
};

/// An axis-aligned box in world coordinates; empty when low > high.
struct Bounds {
  glm::dvec3 low{1e300}, high{-1e300};
  bool is_empty() const { return low.x > high.x; }
  void add(const glm::dvec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
  void add(const Bounds& b) { low = glm::min(low, b.low), high = glm::max(high, b.high); }
  glm::dvec3 centre() const { return (low + high) * 0.5; }
  double radius() const { return is_empty() ? 1.0 : glm::length(high - low) * 0.5; }
};

struct Camera {
  glm::dvec3 target{0};
  double distance = 8;
  double azimuth = -1.0472;    ///< around z; 0 looks from +x
  double elevation = 0.5236;   ///< above the xy plane
  double field_of_view = 0.6;  ///< vertical
  bool orthographic = false;
  bool operator==(const Camera&) const = default;

  glm::dvec3 position() const;
  glm::dvec3 forward() const;
  glm::dvec3 right() const;
  glm::dvec3 up() const;
  glm::dmat4 view() const;
  /// Near and far planes are fitted around `scene`.
  glm::dmat4 projection(double aspect, const Bounds& scene) const;
  /// The ray through a pixel (origin at the top left) of a picture of that size.
  Ray ray(glm::dvec2 pixel, glm::dvec2 size) const;
  /// The pixel at which a point appears, with its depth along `forward` as third coordinate.
  glm::dvec3 project(const glm::dvec3& point, glm::dvec2 size) const;
  /// How long one pixel is in the world at a point.
  double pixel_length(const glm::dvec3& point, glm::dvec2 size) const;

  void orbit(double radians_right, double radians_up);
  void pan(glm::dvec2 pixels, glm::dvec2 size);
  /// Factor below one comes closer; the point under `pixel` stays there.
  void zoom(double factor, glm::dvec2 pixel, glm::dvec2 size);
  void look_at(const Bounds& bounds, double aspect);
};

}  // namespace sectile::viewer
