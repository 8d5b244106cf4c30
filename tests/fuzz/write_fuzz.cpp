// What is written is a legal solid when it is read back, in doubles, floats and on grids, whatever
// the solid: an independent checker and the reader say so.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "fuzz/fuzzed_mesh.h"
#include "sectile/sectile.h"
#include "unit/exact_mesh_checker.h"
#include "unit/manifold_check.h"
#include "unit/same_shape.h"

namespace sectile {
namespace {

void require(bool condition, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "violated: %s\n", what.c_str());
  std::abort();
}

// Repaired, turned by anything, from hardly to by much, and somewhere in space.
Solid placed(Bytes& bytes) {
  RepairOptions options;
  options.close_holes = true;
  Solid solid;
  try {
    solid = repair(fuzzed_mesh(bytes), options);
  } catch (const InvalidSolid&) {
    return solid;
  }
  double angle = 1 + bytes.take();
  for (unsigned i = bytes.below(14); i > 0; --i) angle /= 10;
  const Vec3 axis{double(bytes.take()) - 127.5, double(bytes.take()) - 127.5, 1};
  const double size = std::ldexp(1 + bytes.take() / 256.0, int(bytes.below(5)) - 2);
  return transformed(solid, Transform::translation({bytes.take() / 3.0, 0, bytes.take() / 7.0}) *
                                Transform::rotation_degrees(axis, angle) *
                                Transform::scaling({size, size, size}));
}

void read_back(const PolygonMesh& mesh, FileFormat format) {
  std::stringstream file;
  write_mesh(file, format, mesh, "fuzzed");
  try {
    Solid::from_mesh(read_mesh(file, format, "fuzzed"));
  } catch (const InvalidSolid& error) {
    require(false, std::string("what is read back is legal: ") + error.what());
  }
}

}  // namespace
}  // namespace sectile

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sectile;
  Bytes bytes({data, size});
  const Solid a = placed(bytes), b = placed(bytes);
  const Solid result = boolean(a, b, Operation(bytes.below(3)));
  if (result.is_empty()) return 0;
  for (const Rounding::Numbers numbers :
       {Rounding::Numbers::doubles, Rounding::Numbers::floats, Rounding::Numbers::grid}) {
    Rounding rounding;
    rounding.numbers = numbers;
    rounding.spacing = std::ldexp(1.0, -int(bytes.below(8)));
    rounding.separate_touching = bytes.below(4) == 0;
    RoundedMesh rounded;
    try {
      rounded = rounded_mesh(result, rounding);
    } catch (const RoundingFailed&) {
      require(rounding.separate_touching, "without a bound nothing is refused");
      continue;
    }
    const std::string verdict = test::ExactMeshChecker(rounded.mesh).verdict();
    require(verdict.empty(), "what is written is legal: " + verdict);
    require(test::shape_fault(result, rounded).empty(), "what is written is the same solid");
    if (rounding.separate_touching)
      require(test::manifold_fault(rounded.mesh).empty(), "what is separated is a manifold");
    if (rounded.mesh.face_sizes.empty()) continue;
    if (numbers == Rounding::Numbers::doubles) read_back(rounded.mesh, FileFormat::obj);
    if (numbers == Rounding::Numbers::floats) read_back(rounded.mesh, FileFormat::stl_binary);
  }
  return 0;
}
