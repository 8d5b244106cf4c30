#include "crowds.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace sectile::test {
namespace {

Vec3 plus(const Vec3& p, const Vec3& q) {
  return {p.x + q.x, p.y + q.y, p.z + q.z};
}

Vec3 minus(const Vec3& p, const Vec3& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

Vec3 times(double s, const Vec3& p) {
  return {s * p.x, s * p.y, s * p.z};
}

double determinant(const Vec3& u, const Vec3& v, const Vec3& w) {
  return u.x * (v.y * w.z - v.z * w.y) - u.y * (v.x * w.z - v.z * w.x) +
         u.z * (v.x * w.y - v.y * w.x);
}

double& coordinate(Vec3& p, int axis) {
  return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
}

Vec3 unit(int axis) {
  return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0};
}

bool is_zero(const Vec3& p) {
  return p.x == 0 && p.y == 0 && p.z == 0;
}

// One of so many directions around the z-axis, with integers.
Vec3 around(int i, int directions, double size = 1) {
  const double angle = 2 * std::numbers::pi * i / directions;
  return {std::round(64 * size * std::cos(angle)), std::round(64 * size * std::sin(angle)), 0};
}

Vec3 at_height(const Vec3& p, double z) {
  return {p.x, p.y, z};
}

}  // namespace

PolygonMesh CrowdOfFaces::make(void (CrowdOfFaces::*kind)(), int parts) {
  mesh_ = {};
  for (int i = 0; i < parts; ++i) (this->*kind)();
  return mesh_;
}

Vec3 CrowdOfFaces::lattice(int reach) {
  const double x = real(-reach, reach), y = real(-reach, reach), z = real(-reach, reach);
  return {x, y, z};
}

void CrowdOfFaces::rods() {
  Vec3 from = lattice(8), to = lattice(8);
  const int axis = below(3);
  coordinate(from, axis) = -40;
  coordinate(to, axis) = 40;
  tetrahedron(from, plus(from, unit((axis + 1) % 3)), to, plus(to, unit((axis + 2) % 3)));
}

void CrowdOfFaces::bouquet() {
  const Vec3 direction = lattice(6);
  if (is_zero(direction)) return;
  const Vec3 tip = times(real(4, 7), direction), side = lattice(1), other = lattice(1);
  tetrahedron({}, tip, plus(tip, side), plus(tip, other));
}

void CrowdOfFaces::flat_bouquet() {
  Vec3 direction = lattice(10);
  direction.z = real(-1, 1);
  if (direction.x == 0 && direction.y == 0) return;
  const Vec3 tip = times(real(2, 7), direction);
  const double x = real(-1, 1), y = real(-1, 1);
  tetrahedron({}, tip, plus(tip, {0, 0, 1}), plus(tip, {x, y, 0}));
}

void CrowdOfFaces::book() {
  const int direction = below(120), width = 1 + below(3);
  const double start = real(0, 39), low = below(3) == 0 ? 0 : start, high = start + real(1, 40);
  prism({0, 0, low}, at_height(around(direction, 120), low),
        at_height(around(direction + width, 120), low), {0, 0, high - low});
}

void CrowdOfFaces::slanted_book() {
  const int direction = below(120), width = 1 + below(3);
  const double low = real(0, 39), high = low + real(1, 40), z = real(0, 79), other = real(0, 79);
  tetrahedron({0, 0, low}, {0, 0, high}, at_height(around(direction, 120), z),
              at_height(around(direction + width, 120), other));
}

void CrowdOfFaces::threads() {
  const double x = real(0, 59), y = real(0, 59);
  tetrahedron({x, 0, 0}, {x + 1, 0, 0}, {0, y, 50}, {0, y + 1, 50});
}

void CrowdOfFaces::two_hubs() {
  const double x = below(2) == 0 ? 0 : 50;
  Vec3 end = lattice(6);
  end.x = 50 - x;
  tetrahedron({x, 0, 0}, end, plus(end, {0, 1, 0}), plus(end, {0, 0, 1}));
}

void CrowdOfFaces::comb() {
  if (mesh_.positions.empty()) box({-1, -1, 0}, {64, 0, 1});
  const double x = real(0, 59), width = real(1, 2), length = real(4, 33), height = real(1, 3);
  box({x, 0, 0}, {x + width, length, height});
}

void CrowdOfFaces::slanted_comb() {
  const double x = real(0, 59), height = real(1, 3);
  prism({x, 0, 0}, {x + 1, 0, 0}, {x + real(20, 22), 20, 0}, {0, 0, height});
}

void CrowdOfFaces::dice() {
  const Vec3 corner = lattice(8);
  const double size = real(1, 3);
  box(corner, plus(corner, {size, size, size}));
}

void CrowdOfFaces::fan_of_plates() {
  const int direction = below(120), width = 1 + below(30);
  const double size = real(2, 3) / 2, height = real(1, 2);
  prism({}, around(direction, 120, size), around(direction + width, 120), {0, 0, height});
}

void CrowdOfFaces::bundle() {
  const Vec3 foot = lattice(6);
  const double z = real(0, 1), length = real(1, 3);
  prism(foot, plus(foot, {1, 0, 0}), plus(foot, {0, 1, z}), times(length, {37, 41, 43}));
}

void CrowdOfFaces::spikes_and_walls() {
  const int direction = 2 * below(60);
  const Vec3 next = around(direction + 1, 120);
  if (below(2) == 0) {
    const double z = real(0, 89);
    tetrahedron(at_height(times(0.5, next), z), at_height(next, z), at_height(next, z + 1),
                at_height(plus(next, {1, 1, 0}), z));
  } else {
    prism({}, around(direction, 120), next, {0, 0, 100});
  }
}

// Those that leave their edges outwards are turned alike around the axis; few others cross them.
// Longer ones are less deep, so that none is within another one.
void CrowdOfFaces::crossing_walls() {
  if (below(12) == 0) {
    const Vec3 along = times(8, lattice(6)), beside = times(4, lattice(4));
    return tetrahedron(times(-1, along), along, beside, plus(beside, lattice(2)));
  }
  const Vec3 out = around(below(120), 120), along{-out.y, out.x, 60};
  const double length = real(1, 3);
  const Vec3 beside = times((4 - length) / 2, out);
  tetrahedron(times(-length, along), times(length, along), beside,
              plus(beside, {0, 0, below(2) == 0 ? -2.0 : 2.0}));
}

void CrowdOfFaces::add(std::span<const Vec3> corners, std::span<const std::uint32_t> sizes,
                       std::span<const std::uint32_t> indices) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  mesh_.positions.insert(mesh_.positions.end(), corners.begin(), corners.end());
  mesh_.face_sizes.insert(mesh_.face_sizes.end(), sizes.begin(), sizes.end());
  for (const std::uint32_t i : indices) mesh_.indices.push_back(first + i);
}

// Those without volume are left out.
void CrowdOfFaces::tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const double volume = determinant(minus(b, a), minus(c, a), minus(d, a));
  if (volume == 0) return;
  const Vec3 corners[] = {a, volume > 0 ? b : c, volume > 0 ? c : b, d};
  constexpr std::uint32_t sizes[] = {3, 3, 3, 3}, indices[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3};
  add(corners, sizes, indices);
}

void CrowdOfFaces::prism(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& up) {
  const double volume = determinant(minus(b, a), minus(c, a), up);
  if (volume == 0) return;
  const Vec3 &second = volume > 0 ? b : c, &third = volume > 0 ? c : b;
  const Vec3 corners[] = {a, second, third, plus(a, up), plus(second, up), plus(third, up)};
  constexpr std::uint32_t sizes[] = {3, 3, 4, 4, 4},
                          indices[] = {0, 2, 1, 3, 4, 5, 0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  add(corners, sizes, indices);
}

void CrowdOfFaces::box(const Vec3& low, const Vec3& high) {
  std::vector<Vec3> corners;
  for (unsigned k = 0; k < 8; ++k)
    corners.push_back({k & 1 ? high.x : low.x, k & 2 ? high.y : low.y, k & 4 ? high.z : low.z});
  constexpr std::uint32_t sizes[] = {4, 4, 4, 4, 4, 4},
                          indices[] = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4,
                                       2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
  add(corners, sizes, indices);
}

std::span<const KindOfCrowd> kinds_of_crowds() {
  static constexpr KindOfCrowd kinds[] = {
      {"Rods", &CrowdOfFaces::rods},
      {"Bouquets", &CrowdOfFaces::bouquet},
      {"FlatBouquets", &CrowdOfFaces::flat_bouquet},
      {"Books", &CrowdOfFaces::book},
      {"SlantedBooks", &CrowdOfFaces::slanted_book},
      {"Threads", &CrowdOfFaces::threads},
      {"NeedlesOfTwoHubs", &CrowdOfFaces::two_hubs},
      {"Combs", &CrowdOfFaces::comb},
      {"SlantedCombs", &CrowdOfFaces::slanted_comb},
      {"Dice", &CrowdOfFaces::dice},
      {"FansOfPlates", &CrowdOfFaces::fan_of_plates},
      {"Bundles", &CrowdOfFaces::bundle},
      {"SpikesAndWalls", &CrowdOfFaces::spikes_and_walls},
      {"CrossingWalls", &CrowdOfFaces::crossing_walls},
  };
  return kinds;
}

}  // namespace sectile::test
