// Random polytopes with corners on a small lattice, so that coplanar faces, edges on faces and
// corners on edges are common, against an exact clipper of convex polytopes.
#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <mutex>
#include <random>
#include <sstream>

#include "cases.h"
#include "inside.h"
#include "lattice_solid.h"
#include "operations.h"
#include "polytope.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

using Points = std::vector<std::array<int, 3>>;
using Faults = std::vector<std::string>;

struct Operand {
  Points points;
  std::uint64_t triangulated = 0;
  Polytope polytope;
  Solid solid;

  Operand(const Points& p, std::uint64_t t)
      : points(p), triangulated(t), polytope(Polytope::hull(p)) {
    if (!polytope.is_empty()) solid = Solid::from_mesh(polytope.mesh(t));
  }
  bool contains(const LatticePoint& p) const {
    if (polytope.is_empty()) return false;
    for (const auto& facet : polytope.facets())
      if (facet.plane.side(p) > 0) return false;
    return true;
  }
  bool has_on_a_plane(const LatticePoint& p) const {
    for (const auto& facet : polytope.facets())
      if (facet.plane.side(p) == 0) return true;
    return false;
  }
};

class Picker {
 public:
  explicit Picker(unsigned seed) : random_(seed) {}
  int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
  Operand operand() {
    while (true) {
      Points points(static_cast<std::size_t>(4 + below(7)));
      for (auto& p : points) p = {below(5), below(5), below(5)};
      // Whole facets, triangles, or some of each.
      const int how = below(3);
      const std::uint64_t some = random_() | std::uint64_t{random_()} << 32;
      const Operand operand(points, how == 0 ? 0 : how == 1 ? ~std::uint64_t{0} : some);
      if (!operand.polytope.is_empty()) return operand;
    }
  }
  /// In the middle between lattice points of a fine lattice.
  LatticePoint sample() {
    const auto c = [&] { return 2 * below(256) + 1; };
    return LatticePoint::reduced(c(), c(), c(), 128);
  }

 private:
  std::mt19937 random_;
};

std::string text(const Rational& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

std::string fault_of_volume(const Solid& solid, const Rational& wanted) {
  const Rational is = exact_volume(solid);
  if (is == wanted && solid.is_empty() == (wanted == 0)) return {};
  return "volume " + text(is) + " instead of " + text(wanted);
}

std::string fault_of_legality(const Solid& solid, bool geometry) {
  const auto violations = validate(solid, geometry);
  return violations.empty() ? std::string() : violations.front().what;
}

template <class IsIn>
std::string fault_of_samples(const Solid& solid, const std::vector<LatticePoint>& samples,
                             const IsIn& is_in) {
  const PolygonMesh mesh = solid.to_mesh();
  for (const LatticePoint& p : samples) {
    const double w = double(p.w);
    if (is_inside(mesh, {double(p.x) / w, double(p.y) / w, double(p.z) / w}) != is_in(p))
      return "a point on the wrong side";
  }
  return {};
}

bool combined(bool a, bool b, Operation operation) {
  return operation == Operation::unite       ? a || b
         : operation == Operation::intersect ? a && b
                                             : a && !b;
}

Rational combined_volume(const Rational& a, const Rational& b, const Rational& common,
                         Operation operation) {
  return operation == Operation::unite       ? Rational(a + b - common)
         : operation == Operation::intersect ? common
                                             : Rational(a - common);
}

// Coplanar triangles of an operand may leave points between corners.
std::string fault_of_corners(const Solid& solid, const Polytope& wanted, bool exactly) {
  const auto is = exact_corners(solid), corners = wanted.corners();
  if (exactly && is != corners) return "other corners";
  if (!std::includes(is.begin(), is.end(), corners.begin(), corners.end())) return "lost corners";
  return {};
}

std::string fault_of_pair(const Operand& a, const Operand& b, Operation operation, bool geometry,
                          Picker& random) {
  try {
    const Solid result = boolean(a.solid, b.solid, operation);
    const Polytope common = a.polytope.clipped(b.polytope);
    if (auto what = fault_of_legality(result, geometry); !what.empty()) return what;
    if (auto what = fault_of_volume(
            result,
            combined_volume(a.polytope.volume(), b.polytope.volume(), common.volume(), operation));
        !what.empty())
      return what;
    if (operation == Operation::intersect)
      if (auto what = fault_of_corners(result, common, a.triangulated == 0 && b.triangulated == 0);
          !what.empty())
        return what;
    std::vector<LatticePoint> samples;
    while (samples.size() < 6)
      if (const LatticePoint p = random.sample(); !a.has_on_a_plane(p) && !b.has_on_a_plane(p))
        samples.push_back(p);
    return fault_of_samples(result, samples, [&](const LatticePoint& p) {
      return combined(a.contains(p), b.contains(p), operation);
    });
  } catch (const Error& error) {
    return error.what();
  }
}

std::string text(const Operand& operand) {
  std::ostringstream out;
  out << "{";
  for (const auto& p : operand.points) out << "{" << p[0] << "," << p[1] << "," << p[2] << "},";
  out << "} 0x" << std::hex << operand.triangulated;
  return out.str();
}

// Without points that a failure does not need.
template <class Fails>
Operand shrunk(Operand operand, const Fails& fails) {
  for (std::size_t i = 0; i < operand.points.size();) {
    Points fewer = operand.points;
    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
    const Operand smaller(fewer, operand.triangulated);
    if (!smaller.polytope.is_empty() && fails(smaller))
      operand = smaller;
    else
      ++i;
  }
  return operand;
}

class FaultList {
 public:
  void add(const std::string& what) {
    const std::lock_guard lock(mutex_);
    if (faults_.size() < 10) faults_.push_back(what);
  }
  const Faults& get() const { return faults_; }

 private:
  std::mutex mutex_;
  Faults faults_;
};

// Every pair has its own seed, so that the work can be shared out in any way.
Faults faults_of_pairs(unsigned first_seed, unsigned count, unsigned geometry_every) {
  FaultList faults;
  tbb::parallel_for(first_seed, first_seed + count, [&](unsigned seed) {
    Picker random(seed);
    const Operand a = random.operand(), b = random.operand();
    const bool geometry = seed % geometry_every == 0;
    for (const Operation operation : all_operations) {
      if (fault_of_pair(a, b, operation, geometry, random).empty()) continue;
      const auto what = [&](const Operand& p, const Operand& q) {
        Picker again(seed);
        return fault_of_pair(p, q, operation, true, again);
      };
      const Operand small_a = shrunk(a, [&](const Operand& p) { return !what(p, b).empty(); });
      const Operand small_b =
          shrunk(b, [&](const Operand& q) { return !what(small_a, q).empty(); });
      faults.add("seed " + std::to_string(seed) + ", " + name_of(operation) + " " + text(small_a) +
                 " with " + text(small_b) + ": " + what(small_a, small_b));
    }
  });
  return faults.get();
}

std::string fault_of_triple(const Operand& p, const Operand& q, const Operand& r,
                            Operation operation, bool turned, Picker& random) {
  try {
    const Solid both = boolean(p.solid, q.solid, Operation::unite);
    const Polytope pr = p.polytope.clipped(r.polytope), qr = q.polytope.clipped(r.polytope),
                   pq = p.polytope.clipped(q.polytope), pqr = pq.clipped(r.polytope);
    const Rational v_both = p.polytope.volume() + q.polytope.volume() - pq.volume(),
                   v_r = r.polytope.volume(), common = pr.volume() + qr.volume() - pqr.volume();
    const Solid result =
        turned ? boolean(r.solid, both, operation) : boolean(both, r.solid, operation);
    if (auto what = fault_of_legality(result, false); !what.empty()) return what;
    const Rational wanted =
        combined_volume(turned ? v_r : v_both, turned ? v_both : v_r, common, operation);
    if (auto what = fault_of_volume(result, wanted); !what.empty()) return what;
    std::vector<LatticePoint> samples;
    while (samples.size() < 6)
      if (const LatticePoint s = random.sample();
          !p.has_on_a_plane(s) && !q.has_on_a_plane(s) && !r.has_on_a_plane(s))
        samples.push_back(s);
    return fault_of_samples(result, samples, [&](const LatticePoint& s) {
      const bool in_both = p.contains(s) || q.contains(s), in_r = r.contains(s);
      return combined(turned ? in_r : in_both, turned ? in_both : in_r, operation);
    });
  } catch (const Error& error) {
    return error.what();
  }
}

Faults faults_of_triples(unsigned first_seed, unsigned count) {
  FaultList faults;
  tbb::parallel_for(first_seed, first_seed + count, [&](unsigned seed) {
    Picker random(seed);
    const Operand p = random.operand(), q = random.operand(), r = random.operand();
    const bool turned = seed % 2 != 0;
    for (const Operation operation : all_operations) {
      if (fault_of_triple(p, q, r, operation, turned, random).empty()) continue;
      const auto what = [&](const Operand& s, const Operand& t, const Operand& u) {
        Picker again(seed);
        return fault_of_triple(s, t, u, operation, turned, again);
      };
      const Operand u = shrunk(r, [&](const Operand& x) { return !what(p, q, x).empty(); });
      const Operand s = shrunk(p, [&](const Operand& x) { return !what(x, q, u).empty(); });
      const Operand t = shrunk(q, [&](const Operand& x) { return !what(s, x, u).empty(); });
      faults.add("seed " + std::to_string(seed) + ", " + name_of(operation) +
                 (turned ? " turned, " : ", ") + text(s) + " and " + text(t) + " with " + text(u) +
                 ": " + what(s, t, u));
    }
  });
  return faults.get();
}

TEST(LatticePolytopes, TheClipperKnowsABlockAndATetrahedron) {
  const Polytope cube = Polytope::hull({{0, 0, 0},
                                        {2, 0, 0},
                                        {0, 2, 0},
                                        {2, 2, 0},
                                        {0, 0, 2},
                                        {2, 0, 2},
                                        {0, 2, 2},
                                        {2, 2, 2},
                                        {1, 1, 2},
                                        {1, 1, 1}});
  EXPECT_EQ(cube.facets().size(), 6u);
  EXPECT_EQ(cube.volume(), 8);
  const Polytope corner = Polytope::hull({{1, 1, 1}, {4, 1, 1}, {1, 4, 1}, {1, 1, 4}});
  EXPECT_EQ(corner.volume(), Rational(27, 6));
  // The cube from 1 to 2, all of whose points fulfil x + y + z <= 6.
  EXPECT_EQ(cube.clipped(corner).volume(), 1);
  EXPECT_EQ(cube.clipped(corner).corners().size(), 8u);
  const Polytope beside = Polytope::hull({{2, 0, 0}, {4, 0, 0}, {2, 2, 0}, {2, 0, 2}});
  EXPECT_TRUE(cube.clipped(beside).is_empty());
}

TEST(LatticePolytopes, SomePairs) {
  EXPECT_EQ(faults_of_pairs(1, 600, 1), Faults{});
}

TEST(LatticePolytopes, SomeUnionsOfTwoWithAThird) {
  EXPECT_EQ(faults_of_triples(1, cases(200)), Faults{});
}

TEST(LatticePolytopesExhaustive, TwentyThousandPairs) {
  EXPECT_EQ(faults_of_pairs(100000, 20000, 16), Faults{});
}

TEST(LatticePolytopesExhaustive, FourThousandUnionsOfTwoWithAThird) {
  EXPECT_EQ(faults_of_triples(200000, 4000), Faults{});
}

}  // namespace
}  // namespace sectile::test
