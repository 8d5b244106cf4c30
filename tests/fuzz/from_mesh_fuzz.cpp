// A mesh is refused with InvalidSolid, or it is a legal solid whose Booleans are legal and have the
// right volumes. SECTILE_FUZZ_SAVE=folder writes the meshes of the input as OBJ files.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "fuzz/fuzzed_mesh.h"
#include "sectile/sectile.h"

namespace sectile {
namespace {

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "violated: %s\n", what);
  std::abort();
}

void save(const PolygonMesh& mesh, const std::string& path) {
  std::ofstream out(path);
  out.precision(17);
  for (const Vec3& p : mesh.positions) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  auto corner = mesh.indices.begin();
  for (const std::uint32_t n : mesh.face_sizes) {
    out << 'f';
    for (std::uint32_t i = 0; i < n; ++i) out << ' ' << *corner++ + 1;
    out << '\n';
  }
}

void require_legal(const Solid& solid, const char* name) {
  for (const Violation& v : validate(solid)) {
    std::fprintf(stderr, "%s: %s\n", name, v.what.c_str());
    require(false, "a result is legal");
  }
}

// Nothing if the mesh is no solid. That faces cross is for the validator to find.
std::optional<Solid> operand(const PolygonMesh& mesh) {
  std::optional<Solid> solid;
  try {
    solid = Solid::from_mesh(mesh);
  } catch (const InvalidSolid&) {
    return {};
  }
  for (const Violation& v : validate(*solid, false)) {
    std::fprintf(stderr, "%s\n", v.what.c_str());
    require(false, "an imported solid's links, planes and loops are in order");
  }
  if (!validate(*solid).empty()) return {};
  return solid;
}

void check(const Solid& a, const Solid& b) {
  const Solid both = boolean(a, b, Operation::unite), common = boolean(a, b, Operation::intersect),
              rest = boolean(a, b, Operation::subtract);
  require_legal(both, "union");
  require_legal(common, "intersection");
  require_legal(rest, "difference");
  const double sum = a.volume() + b.volume();
  const auto equal = [&](double x, double y) { return std::abs(x - y) <= 1e-9 * (1 + sum); };
  require(a.volume() > 0 && b.volume() > 0, "volumes are positive");
  require(equal(both.volume() + common.volume(), sum),
          "vol(A or B) + vol(A and B) = vol A + vol B");
  require(equal(rest.volume() + common.volume(), a.volume()), "vol(A - B) + vol(A and B) = vol A");
}

}  // namespace
}  // namespace sectile

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace sectile;
  Bytes bytes({data, size});
  const PolygonMesh first = fuzzed_mesh(bytes), second = fuzzed_mesh(bytes);
  if (const char* folder = std::getenv("SECTILE_FUZZ_SAVE")) {
    save(first, std::string(folder) + "/a.obj");
    save(second, std::string(folder) + "/b.obj");
  }
  const auto a = operand(first), b = operand(second);
  if (a && b && !a->is_empty() && !b->is_empty()) check(*a, *b);
  return 0;
}
