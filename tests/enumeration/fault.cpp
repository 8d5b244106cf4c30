#include "fault.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "inside.h"
#include "sectile/validate.h"

namespace sectile::test {
namespace {

std::string difference(const char* what, double is, double wanted) {
  return std::string(what) + " " + std::to_string(is) + " instead of " + std::to_string(wanted);
}

std::string fault_of_measures(const Solid& solid, const Complex& complex, Mask wanted) {
  const double volume = complex.volume(wanted), area = complex.area(wanted);
  if (solid.volume() != volume) return difference("volume", solid.volume(), volume);
  const double allowed = complex.has_integer_areas() ? 0 : 1e-13 * area;
  if (!(std::abs(solid.area() - area) <= allowed)) return difference("area", solid.area(), area);
  return {};
}

std::string fault_of_shells(const Solid& solid, const Complex& complex, Mask wanted) {
  const SolidCounts counts = solid.counts();
  const Boundary boundary(complex, wanted);
  if (counts.shells != static_cast<std::size_t>(boundary.shell_count()))
    return difference("shells", double(counts.shells), boundary.shell_count());
  if (counts.genus != boundary.genus())
    return difference("genus", double(counts.genus), boundary.genus());
  return {};
}

}  // namespace

std::string fault_of_closure(const PolygonMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = mesh.indices[i + k], to = mesh.indices[i + (k + 1) % 3];
      balance[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  for (const auto& [edge, sum] : balance)
    if (sum != 0)
      return "open between corners " + std::to_string(edge.first) + " and " +
             std::to_string(edge.second);
  return {};
}

std::string fault(const Solid& solid, const Complex& complex, Mask wanted, bool geometry) {
  if (const std::string what = fault_of_measures(solid, complex, wanted); !what.empty())
    return what;
  if (const auto violations = validate(solid, geometry); !violations.empty())
    return violations.front().what;
  if (const std::string what = fault_of_shells(solid, complex, wanted); !what.empty()) return what;
  const PolygonMesh mesh = solid.to_mesh();
  if (const std::string what = fault_of_closure(mesh); !what.empty()) return what;
  for (int c = 0; c < complex.cell_count(); ++c)
    if (is_inside(mesh, complex.cell(c).centre) != Complex::has(wanted, c))
      return "cell " + std::to_string(c) + " on the wrong side";
  return {};
}

std::pair<Mask, Mask> shrunk(Mask a, Mask b, const std::function<bool(Mask, Mask)>& fails) {
  for (bool changed = true; changed;) {
    changed = false;
    for (Mask cell = 1; cell != 0; cell <<= 1) {
      if ((a & cell) != 0 && a != cell && fails(a & ~cell, b)) {
        a &= ~cell;
        changed = true;
      }
      if ((b & cell) != 0 && b != cell && fails(a, b & ~cell)) {
        b &= ~cell;
        changed = true;
      }
    }
  }
  return {a, b};
}

}  // namespace sectile::test
