#include "boolean/save_operands.h"

#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>

namespace sectile {
namespace {

void write(const std::filesystem::path& path, const Solid& solid) {
  std::ofstream out(path);
  out.exceptions(std::ios::failbit | std::ios::badbit);
  out << std::setprecision(std::numeric_limits<double>::max_digits10);
  const PolygonMesh mesh = solid.to_mesh();
  for (const Vec3& p : mesh.positions) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    out << "f " << mesh.indices[i] + 1 << ' ' << mesh.indices[i + 1] + 1 << ' '
        << mesh.indices[i + 2] + 1 << '\n';
  out.close();
}

}  // namespace

std::string save_operands(const Solid& a, const Solid& b) {
  static std::atomic<unsigned> count{0};
  try {
    const auto stem = std::filesystem::temp_directory_path() /
                      ("sectile-" + std::to_string(getpid()) + "-" + std::to_string(++count));
    write(stem.string() + "-a.obj", a);
    write(stem.string() + "-b.obj", b);
    return "the operands were saved as " + stem.string() + "-a.obj and -b.obj";
  } catch (const std::exception& error) {
    return std::string("the operands could not be saved: ") + error.what();
  }
}

}  // namespace sectile
