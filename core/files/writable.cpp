#include "files/writable.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string>

#include "sectile/errors.h"

namespace sectile {
namespace {

[[noreturn]] void refuse(std::string_view name, const std::string& why) {
  throw FileError(std::string(name) + ": cannot write: " + why);
}

bool is_finite(const Vec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace

void require_writable(const PolygonMesh& mesh, std::string_view name) {
  const std::uint64_t corners =
      std::accumulate(mesh.face_sizes.begin(), mesh.face_sizes.end(), std::uint64_t{0});
  if (corners != mesh.indices.size())
    refuse(name, "the faces have " + std::to_string(corners) + " corners, but there are " +
                     std::to_string(mesh.indices.size()) + " indices");
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f)
    if (mesh.face_sizes[f] < 3)
      refuse(name, "face " + std::to_string(f) + " has fewer than three corners");
  for (const std::uint32_t index : mesh.indices)
    if (index >= mesh.positions.size())
      refuse(name, "there is no position " + std::to_string(index) + "; there are " +
                       std::to_string(mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    if (!is_finite(mesh.positions[i]))
      refuse(name, "position " + std::to_string(i) + " is not finite");
}

void require_triangles(const PolygonMesh& mesh, std::string_view name, std::string_view format) {
  for (std::size_t f = 0; f < mesh.face_sizes.size(); ++f)
    if (mesh.face_sizes[f] != 3)
      refuse(name, std::string(format) + " holds only triangles, but face " + std::to_string(f) +
                       " has " + std::to_string(mesh.face_sizes[f]) + " corners");
}

float writable_float(double value, std::string_view name, std::string_view format, float most) {
  if (!(std::abs(value) <= most)) {
    std::array<char, 16> digits{};
    std::to_chars(digits.data(), digits.data() + digits.size(), most, std::chars_format::general,
                  2);
    refuse(name, std::string(format) + " holds no coordinates beyond " + digits.data() +
                     "; use another format");
  }
  return static_cast<float>(value);
}

}  // namespace sectile
