// Soups of overlapping lattice boxes, tetrahedra and prisms in one mesh, against counted cells.
#include "sectile/repair.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <random>

#include "cases.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

// A prime: points at some multiples of its inverse lie on no face between lattice points near them.
constexpr int parts_of_unit = 1009;

// A convex lattice polytope, as triangles that are turned outwards unless they are not.
struct Part {
  std::vector<std::array<int, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;  // counter-clockwise from outside
  int sign = 1;                                         // -1: inside out

  /// A point in parts of the lattice's unit.
  bool has(const std::array<int, 3>& at) const {
    for (const auto& t : triangles) {
      long n[3], u[3], v[3], w[3];
      for (int k = 0; k < 3; ++k) {
        u[k] = points[t[1]][k] - points[t[0]][k];
        v[k] = points[t[2]][k] - points[t[0]][k];
        w[k] = at[k] - long(parts_of_unit) * points[t[0]][k];
      }
      n[0] = u[1] * v[2] - u[2] * v[1];
      n[1] = u[2] * v[0] - u[0] * v[2];
      n[2] = u[0] * v[1] - u[1] * v[0];
      if (n[0] * w[0] + n[1] * w[1] + n[2] * w[2] >= 0) return false;
    }
    return true;
  }
};

Part box(const std::array<int, 3>& low, const std::array<int, 3>& high) {
  Part part;
  for (unsigned i = 0; i < 8; ++i)
    part.points.push_back(
        {i & 1 ? high[0] : low[0], i & 2 ? high[1] : low[1], i & 4 ? high[2] : low[2]});
  part.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return part;
}

Part tetrahedron(const std::array<int, 3>& corner, const std::array<int, 3>& legs) {
  Part part;
  part.points.assign(4, corner);
  for (std::size_t k = 0; k < 3; ++k) part.points[k + 1][k] += legs[k];
  part.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
  if (legs[0] * legs[1] * legs[2] < 0)
    for (auto& t : part.triangles) std::swap(t[1], t[2]);
  return part;
}

// A wedge: half of a box, cut along a diagonal of its xy sides.
Part prism(const std::array<int, 3>& low, const std::array<int, 3>& high) {
  Part part;
  for (const int z : {low[2], high[2]})
    part.points.insert(part.points.end(),
                       {{low[0], low[1], z}, {high[0], low[1], z}, {low[0], high[1], z}});
  part.triangles = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3},
                    {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};
  return part;
}

class Soup {
 public:
  static constexpr int size = 4;

  Soup(std::mt19937& random, bool turned) : random_(random) {
    const std::size_t count = 2 + random() % 11;
    for (std::size_t i = 0; i < count; ++i) {
      parts_.push_back(random_part());
      if (turned && random() % 3 == 0) parts_.back().sign = -1;
    }
  }

  PolygonMesh mesh(bool shared) {
    PolygonMesh mesh;
    std::map<std::array<int, 3>, std::uint32_t> known;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const Part& part : parts_) {
      const auto vertex = [&](std::uint32_t i) {
        const auto next = static_cast<std::uint32_t>(mesh.positions.size());
        const auto& p = part.points[i];
        if (shared) {
          const auto [at, made] = known.try_emplace(p, next);
          if (!made) return at->second;
        }
        mesh.positions.push_back({double(p[0]), double(p[1]), double(p[2])});
        return next;
      };
      for (const auto& t : part.triangles) {
        std::array<std::uint32_t, 3> v{vertex(t[0]), vertex(t[1]), vertex(t[2])};
        if (part.sign < 0) std::swap(v[1], v[2]);
        triangles.push_back(v);
      }
    }
    std::shuffle(triangles.begin(), triangles.end(), random_);
    for (const auto& t : triangles) {
      mesh.indices.insert(mesh.indices.end(), t.begin(), t.end());
      mesh.face_sizes.push_back(3);
    }
    return mesh;
  }

  int winding(const std::array<int, 3>& at) const {
    int sum = 0;
    for (const Part& p : parts_) sum += p.sign * p.has(at);
    return sum;
  }
  const std::vector<Part>& parts() const { return parts_; }

 private:
  Part random_part() {
    std::array<int, 3> low, high, legs;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = static_cast<int>(random_() % size);
      high[k] = low[k] + 1 + static_cast<int>(random_() % unsigned(size - low[k]));
      legs[k] = high[k] - low[k];
    }
    switch (random_() % 3) {
      case 0:
        return box(low, high);
      case 1:
        return prism(low, high);
      default:
        for (std::size_t k = 0; k < 3; ++k)
          if (random_() % 2 == 0) {
            low[k] = high[k];
            legs[k] = -legs[k];
          }
        return tetrahedron(low, legs);
    }
  }

  std::mt19937& random_;
  std::vector<Part> parts_;
};

bool is_material(Rule rule, int winding) {
  return rule == Rule::positive  ? winding > 0
         : rule == Rule::nonzero ? winding != 0
                                 : winding % 2 != 0;
}

// By a ray through the triangles of the result.
bool is_inside(const PolygonMesh& mesh, const Vec3& p) {
  int crossings = 0;
  for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[t]], &b = mesh.positions[mesh.indices[t + 1]],
               &c = mesh.positions[mesh.indices[t + 2]];
    const auto turn = [](double ay, double az, double by, double bz, double cy, double cz) {
      return (by - ay) * (cz - az) - (bz - az) * (cy - ay);
    };
    const double whole = turn(a.y, a.z, b.y, b.z, c.y, c.z);
    if (whole == 0) continue;
    const double u = turn(p.y, p.z, b.y, b.z, c.y, c.z) / whole,
                 v = turn(a.y, a.z, p.y, p.z, c.y, c.z) / whole,
                 w = turn(a.y, a.z, b.y, b.z, p.y, p.z) / whole;
    if (u < 0 || v < 0 || w < 0) continue;
    if (u * a.x + v * b.x + w * c.x > p.x) ++crossings;
  }
  return crossings % 2 != 0;
}

void check_soups(unsigned seed, int rounds) {
  std::mt19937 random(seed);
  for (int round = 0; round < rounds; ++round) {
    SCOPED_TRACE("seed " + std::to_string(seed) + " round " + std::to_string(round));
    const bool turned = random() % 2 == 0;
    Soup soup(random, turned);
    const PolygonMesh mesh = soup.mesh(random() % 2 == 0);
    for (const Rule rule : {Rule::positive, Rule::nonzero, Rule::odd}) {
      if (rule == Rule::positive && turned) continue;  // parts inside out are another test
      RepairOptions options;
      options.rule = rule;
      const Solid solid = repair(mesh, options);
      const auto found = validate(solid);
      ASSERT_TRUE(found.empty()) << found.front().what;
      const PolygonMesh result = solid.to_mesh();
      for (int i = 0; i < 60; ++i) {
        std::array<int, 3> at;
        for (std::size_t k = 0; k < 3; ++k)
          at[k] = parts_of_unit * static_cast<int>(random() % Soup::size) +
                  static_cast<int>(std::array<unsigned, 3>{101, 307, 701}[(k + random() % 3) % 3]);
        if (at[0] % parts_of_unit == at[1] % parts_of_unit ||
            at[1] % parts_of_unit == at[2] % parts_of_unit ||
            at[2] % parts_of_unit == at[0] % parts_of_unit)
          continue;
        const auto coordinate = [&](std::size_t k) { return double(at[k]) / parts_of_unit; };
        ASSERT_EQ(is_inside(result, {coordinate(0), coordinate(1), coordinate(2)}),
                  is_material(rule, soup.winding(at)))
            << "rule " << int(rule) << " at " << at[0] << ' ' << at[1] << ' ' << at[2];
      }
    }
  }
}

TEST(Repair, SoupsOfOverlappingParts) {
  check_soups(1, cases(300));
}

}  // namespace
}  // namespace sectile
