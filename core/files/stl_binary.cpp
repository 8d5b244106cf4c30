#include "files/stl_binary.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include "files/facet_normal.h"
#include "files/formats.h"
#include "files/writable.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

static_assert(std::endian::native == std::endian::little);
constexpr std::size_t comment_size = 80, header_size = 84, facet_size = 50, normal_size = 12,
                      corner_size = 12;

template <class T>
T value_at(const char* at) {
  T value;
  std::memcpy(&value, at, sizeof value);
  return value;
}

std::uint64_t size_with(std::uint32_t triangles) {
  return header_size + facet_size * std::uint64_t{triangles};
}

[[noreturn]] void fail(std::string_view name, std::size_t at, const std::string& what) {
  throw FileError(std::string(name) + ": byte " + std::to_string(at) + ": " + what);
}

float as_float(double value, std::string_view name) {
  return writable_float(value, name, "binary STL", std::numeric_limits<float>::max());
}

}  // namespace

bool may_be_binary_stl(std::string_view content) {
  return content.size() >= header_size;
}

bool has_size_of_binary_stl(std::string_view content) {
  return may_be_binary_stl(content) &&
         content.size() == size_with(value_at<std::uint32_t>(content.data() + comment_size));
}

PolygonMesh read_stl_binary(std::string_view content, std::string_view name) {
  const auto count = value_at<std::uint32_t>(content.data() + comment_size);
  if (!has_size_of_binary_stl(content))
    fail(name, content.size(),
         std::to_string(count) + " triangles need " + std::to_string(size_with(count)) +
             " bytes, but the file has " + std::to_string(content.size()));
  if (count > std::numeric_limits<std::uint32_t>::max() / 3)
    fail(name, comment_size, "more triangles than corners can be counted");
  PolygonMesh mesh;
  mesh.face_sizes.assign(count, 3);
  mesh.positions.reserve(3 * std::size_t{count});
  mesh.indices.reserve(3 * std::size_t{count});
  for (std::uint32_t corner = 0; corner < 3 * count; ++corner) {
    const std::size_t at = header_size + facet_size * std::size_t{corner / 3} + normal_size +
                           corner_size * std::size_t{corner % 3};
    const auto [x, y, z] = value_at<std::array<float, 3>>(content.data() + at);
    if (!std::isfinite(x) || !std::isfinite(y) || !std::isfinite(z))
      fail(name, at,
           "triangle " + std::to_string(corner / 3) + " has a coordinate that is not finite");
    mesh.indices.push_back(corner);
    mesh.positions.push_back({x, y, z});
  }
  return mesh;
}

void write_stl_binary(Sink& out, const PolygonMesh& mesh, std::string_view name) {
  require_triangles(mesh, name, "STL");
  std::array<char, comment_size> comment{"binary STL by sectile"};
  out.bytes(comment).bytes(static_cast<std::uint32_t>(mesh.face_sizes.size()));
  const auto put = [&](const Vec3& p) {
    out.bytes(std::array{as_float(p.x, name), as_float(p.y, name), as_float(p.z, name)});
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const Vec3 &a = mesh.positions[mesh.indices[i]], &b = mesh.positions[mesh.indices[i + 1]],
               &c = mesh.positions[mesh.indices[i + 2]];
    put(facet_normal(a, b, c));
    for (const Vec3* p : {&a, &b, &c}) put(*p);
    out.bytes(std::uint16_t{0});
  }
}

}  // namespace sectile
