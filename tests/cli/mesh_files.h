// Small meshes and their files in every format, written without the library that reads them.
#pragma once

#include <array>
#include <string>
#include <vector>

namespace sectile::test {

struct FileMesh {
  std::vector<std::array<double, 3>> positions;
  std::vector<std::vector<int>> faces;  ///< counted from 0
};

/// The cube of side 2 with this lowest corner.
FileMesh cube(double x, double y, double z);
/// Both in one mesh.
FileMesh together(const FileMesh& a, const FileMesh& b);
/// A prism over a quadrilateral whose sides cross.
FileMesh self_crossing_prism();
/// A grid of n times n quadrilaterals on each side of a cube, bulged: large and closed.
FileMesh bulged_cube(int n, double bulge);

enum class Format { obj, off, ply, ply_binary, stl, stl_binary };
inline constexpr Format all_formats[] = {Format::obj,        Format::off, Format::ply,
                                         Format::ply_binary, Format::stl, Format::stl_binary};
std::string name_of(Format format);
std::string extension_of(Format format);
/// Polygons become fans in STL.
std::string content(const FileMesh& mesh, Format format);

}  // namespace sectile::test
