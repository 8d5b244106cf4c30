// Crowds: very many faces around one point, along one line, in one plane, or long and thin between
// each other. Each kind has its own way through the searches; small crowds of coordinates that are
// small integers share points, lines and planes with each other everywhere.
#pragma once

#include <random>
#include <span>

#include "sectile/mesh.h"

namespace sectile::test {

class CrowdOfFaces {
 public:
  explicit CrowdOfFaces(std::mt19937& random) : random_(random) {}

  void rods();              // between opposite faces of a cube
  void bouquet();           // spikes from one point
  void flat_bouquet();      // all near one plane
  void book();              // walls along a line that end anywhere
  void slanted_book();      // walls that are tetrahedra
  void threads();           // needles from one line to another
  void two_hubs();          // needles from two points
  void comb();              // plates on a ground
  void slanted_comb();      // plates side by side
  void dice();              // small cubes
  void fan_of_plates();     // sectors of a disc, of two heights
  void bundle();            // slanted rods side by side
  void spikes_and_walls();  // around one line
  void crossing_walls();    // with edges through one point

  /// How many parts, and then one of the kinds above.
  PolygonMesh make(void (CrowdOfFaces::*kind)(), int parts);

 private:
  int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }
  double real(int low, int high) { return low + below(high - low + 1); }
  Vec3 lattice(int reach);

  void add(std::span<const Vec3> corners, std::span<const std::uint32_t> sizes,
           std::span<const std::uint32_t> indices);
  void tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
  void prism(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& up);
  void box(const Vec3& low, const Vec3& high);

  std::mt19937& random_;
  PolygonMesh mesh_;
};

struct KindOfCrowd {
  const char* name;
  void (CrowdOfFaces::*kind)();
};
std::span<const KindOfCrowd> kinds_of_crowds();

}  // namespace sectile::test
