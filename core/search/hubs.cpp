#include "search/hubs.h"

#include <cmath>

#include "numbers/rounding.h"

namespace sectile {
namespace {

std::vector<std::uint32_t> corners_at_points(const Brep& brep) {
  std::uint32_t last = 0;
  for (const PointId p : brep.point) last = std::max(last, p.value());
  std::vector<std::uint32_t> count(std::size_t(last) + 1, 0);
  for (const VertexId v : brep.origin) ++count[brep.point_of(v).value()];
  return count;
}

double largest(const Vec3& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

using rounding::unit;

// A length within these bounds has a square that is a normal double.
constexpr double least_length = 0x1p-500, greatest_length = 0x1p500;

// Collects directions. With an angle of at most 60 degrees between any two of them, every direction
// between them is near the box of their unit vectors. The bounds of rounding errors only make the
// box wider; what boxes do not separate is tested exactly.
class Directions {
 public:
  explicit Directions(const Vec3& centre) : centre_(centre) {}

  void add(const Vec3& p) {
    const Vec3 d{p.x - centre_.x, p.y - centre_.y, p.z - centre_.z};
    const double length = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    if (!(length > least_length && length < greatest_length)) {
      known_ = false;
      return;
    }
    bounds_.add({d.x / length, d.y / length, d.z / length});
    // On each axis two rounded positions and their difference: 2 u (|p| + |c|). That makes less
    // than 4 u (|p| + |c|) for the vector, and twice its share of the length for the direction.
    error_ = std::max(error_, 8 * unit * (largest(p) + largest(centre_)) / length);
  }

  Box box() const {
    if (!known_) return Box::everything();
    const Vec3 size{bounds_.high.x - bounds_.low.x, bounds_.high.y - bounds_.low.y,
                    bounds_.high.z - bounds_.low.z};
    const double spread = size.x * size.x + size.y * size.y + size.z * size.z + 8 * error_;
    if (!(spread <= 1)) return Box::everything();
    // A sum of unit vectors that are `sqrt(spread)` apart at most, with weights that add up to one,
    // is longer than sqrt(1 - spread / 2), and that than 1 - spread / 2. Square root, quotients and
    // these sums are rounded less than 16 times.
    const double margin = spread / 2 + 2 * error_ + 16 * unit;
    Bounds wider;
    wider.add({bounds_.low.x - margin, bounds_.low.y - margin, bounds_.low.z - margin});
    wider.add({bounds_.high.x + margin, bounds_.high.y + margin, bounds_.high.z + margin});
    return wider.box();
  }

 private:
  Vec3 centre_;
  Bounds bounds_;
  double error_ = 0;
  bool known_ = true;
};

}  // namespace

Hubs::Hubs(const Brep& brep) {
  if (brep.face_count() < least_faces) return;
  const std::vector<std::uint32_t> corners = corners_at_points(brep);
  std::vector<std::uint32_t> hub_at;
  for (std::size_t p = 0; p < corners.size(); ++p) {
    if (corners[p] < least_faces) continue;
    if (hub_at.empty()) hub_at.assign(corners.size(), none);
    hub_at[p] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(PointId(p));
  }
  if (points_.empty()) return;
  of_face_.assign(brep.face_count(), none);
  face_end_.assign(points_.size(), 0);
  for (std::size_t f = 0; f < of_face_.size(); ++f) {
    std::uint32_t most = 0;
    for_each_in_face(brep, FaceId(f), [&](HalfEdgeId h) {
      const std::uint32_t p = brep.point_of(brep.from(h)).value();
      if (hub_at[p] == none || corners[p] <= most) return;
      most = corners[p];
      of_face_[f] = hub_at[p];
    });
    if (of_face_[f] != none) ++face_end_[of_face_[f]];
  }
  std::uint32_t end = 0;
  for (std::uint32_t& e : face_end_) {
    const std::uint32_t count = e;
    e = end;
    end += count;
  }
  faces_.resize(end);
  for (std::size_t f = 0; f < of_face_.size(); ++f)
    if (of_face_[f] != none) faces_[face_end_[of_face_[f]]++] = FaceId(f);
}

Box direction_box(const Vec3& hub, std::span<const Vec3> points) {
  Directions directions(hub);
  for (const Vec3& p : points) directions.add(p);
  return directions.box();
}

std::vector<Box> direction_boxes(const Brep& brep, const Geometry& geometry, PointId hub,
                                 std::span<const FaceId> faces) {
  std::vector<Box> boxes;
  boxes.reserve(faces.size());
  for (const FaceId f : faces) {
    Directions directions(geometry.position(hub));
    for_each_in_loop(brep, brep.outer_loop[f], [&](HalfEdgeId h) {
      const PointId p = brep.point_of(brep.from(h));
      if (p != hub) directions.add(geometry.position(p));
    });
    boxes.push_back(directions.box());
  }
  return boxes;
}

}  // namespace sectile
