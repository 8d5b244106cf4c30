// Everything round: prisms, cylinders, pyramids, cones and tori are revolutions too.
#include <array>
#include <string>

#include "primitives/arguments.h"
#include "primitives/circle.h"
#include "primitives/profile.h"
#include "primitives/soup_builder.h"

namespace sectile {

namespace {

using Ring = std::vector<std::uint32_t>;  // empty if it is a point on the axis

class Revolution {
 public:
  explicit Revolution(std::uint32_t segments) : segments_(segments) {
    for (std::uint32_t k = 0; k < segments; ++k) circle_.push_back(circle_point(k, segments));
  }

  void add(const ProfileLoop& loop) {
    std::vector<Ring> rings;
    for (const Vec2& p : loop) rings.push_back(add_ring(p));
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t j = (i + 1) % loop.size();
      if (rings[i].empty() && rings[j].empty()) continue;
      if (loop[i].y == loop[j].y)
        add_disc(rings[i], rings[j]);
      else if (rings[i].empty())
        add_fan(loop[i].y, Ring(rings[j].rbegin(), rings[j].rend()));
      else if (rings[j].empty())
        add_fan(loop[j].y, rings[i]);
      else
        add_band(rings[i], rings[j], loop[i].x > loop[j].x);
    }
  }

  Solid solid() const { return soup_.solid(); }

 private:
  Ring add_ring(const Vec2& p) {
    Ring ring;
    if (p.x == 0) return ring;
    for (const Vec2& direction : circle_)
      ring.push_back(soup_.add_position({p.x * direction.x, p.x * direction.y, p.y}));
    return ring;
  }

  /// A face at one height: a polygon, with a hole if it does not reach the axis.
  void add_disc(const Ring& a, const Ring& b) {
    const Ring reversed(b.rbegin(), b.rend());
    if (b.empty()) return soup_.add_face(a);
    if (a.empty()) return soup_.add_face(reversed);
    const bool top = soup_.position(a[0]).x > soup_.position(b[0]).x;
    soup_.add_face(std::array{top ? a : reversed, top ? reversed : a});
  }

  void add_fan(double height, const Ring& ring) {
    const std::uint32_t apex = soup_.add_position({0, 0, height});
    for (std::uint32_t k = 0; k < segments_; ++k)
      soup_.add_face({ring[k], ring[k + 1 == segments_ ? 0 : k + 1], apex});
  }

  void add_band(const Ring& a, const Ring& b, bool narrowing) {
    for (std::uint32_t k = 0; k < segments_; ++k) {
      const std::uint32_t l = k + 1 == segments_ ? 0 : k + 1;
      add_quadrilateral(a[k], a[l], b[l], b[k], narrowing != odd_octant(k));
    }
  }

  // The diagonal leaves the wider ring at the first corner in even octants, at the second corner
  // in odd ones: mirror images of the solid have mirrored diagonals.
  bool odd_octant(std::uint64_t k) const { return (4 * (2 * k + 1) / segments_) % 2 == 1; }

  void add_quadrilateral(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
                         bool diagonal_from_a) {
    if (coplanar(soup_.position(a), soup_.position(b), soup_.position(c), soup_.position(d))) {
      soup_.add_face({a, b, c, d});
    } else if (diagonal_from_a) {
      soup_.add_face({a, b, c});
      soup_.add_face({a, c, d});
    } else {
      soup_.add_face({a, b, d});
      soup_.add_face({b, c, d});
    }
  }

  std::uint32_t segments_;
  std::vector<Vec2> circle_;
  SoupBuilder soup_;
};

Solid turned(const std::vector<ProfileLoop>& loops, std::uint32_t segments) {
  std::uint64_t corners = 0;
  for (const ProfileLoop& loop : loops) corners += loop.size();
  require_size(corners * segments);
  Revolution revolution(segments);
  for (const ProfileLoop& loop : loops) revolution.add(loop);
  return revolution.solid();
}

Solid round_column(double radius, double height, std::uint32_t segments) {
  require_length(radius, "radius");
  require_length(height, "height");
  return turned({{{0, 0}, {radius, 0}, {radius, height}, {0, height}}}, segments);
}

Solid round_spike(double radius, double height, std::uint32_t segments) {
  require_length(radius, "radius");
  require_length(height, "height");
  return turned({{{0, 0}, {radius, 0}, {0, height}}}, segments);
}

}  // namespace

Solid prism(double radius, double height, std::uint32_t sides) {
  require_count(sides, 3, "sides");
  return round_column(radius, height, sides);
}

Solid pyramid(double radius, double height, std::uint32_t sides) {
  require_count(sides, 3, "sides");
  return round_spike(radius, height, sides);
}

Solid cylinder(double radius, double height, std::uint32_t segments) {
  require_count(segments, 3, "segments");
  return round_column(radius, height, segments);
}

Solid cone(double bottom_radius, double top_radius, double height, std::uint32_t segments) {
  require_count(segments, 3, "segments");
  if (top_radius == 0) return round_spike(bottom_radius, height, segments);
  require_length(bottom_radius, "bottom radius");
  require_length(top_radius, "top radius");
  require_length(height, "height");
  return turned({{{0, 0}, {bottom_radius, 0}, {top_radius, height}, {0, height}}}, segments);
}

Solid torus(double major_radius, double minor_radius, std::uint32_t major_segments,
            std::uint32_t minor_segments) {
  require_length(major_radius, "major radius");
  require_length(minor_radius, "minor radius");
  require(minor_radius < major_radius,
          "The minor radius must be smaller than the major radius, or the torus meets itself.");
  require_count(major_segments, 3, "major segments");
  require_count(minor_segments, 3, "minor segments");
  require_size(std::uint64_t{major_segments} * minor_segments);
  ProfileLoop loop;
  for (std::uint32_t k = 0; k < minor_segments; ++k) {
    const Vec2 direction = circle_point(k, minor_segments);
    loop.push_back({major_radius + minor_radius * direction.x, minor_radius * direction.y});
  }
  return turned({loop}, major_segments);
}

Solid revolve(const Profile& profile, std::uint32_t segments) {
  require_count(segments, 3, "segments");
  const std::vector<ProfileLoop> loops = mended_loops(profile);
  for (const ProfileLoop& loop : loops)
    for (const Vec2& p : loop)
      require(p.x >= 0, "The profile reaches x = " + std::to_string(p.x) +
                            "; it must not cross the axis x = 0.");
  return turned(loops, segments);
}

}  // namespace sectile
