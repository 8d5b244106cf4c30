// Reading and writing meshes: OBJ, STL (text and binary), OFF, PLY, 3MF.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sectile/mesh.h"

namespace sectile {

enum class FileFormat { obj, stl_text, stl_binary, off, ply_text, ply_binary, three_mf };

/// The format a file name's extension stands for (".stl" is binary, ".ply" is text when written).
/// Throws FileError for an unknown extension.
FileFormat format_of(const std::filesystem::path& path);

/// Reads a mesh. STL and PLY files tell by themselves whether they are text or binary. Coordinates
/// are rounded correctly; polygons of any size are kept; nothing is dropped silently. What a 3MF
/// file builds becomes one mesh, as if its items were one soup.
/// Throws FileError (the message starts with "NAME:LINE: ", "NAME: byte N: " or "NAME: PART: ").
PolygonMesh read_mesh(const std::filesystem::path& path);
PolygonMesh read_mesh(std::istream& in, FileFormat format, std::string_view name);

/// Writes a mesh. The file appears whole or not at all. Coordinates are written so that they read
/// back as the same doubles, except in binary STL and 3MF, which hold floats: there they are
/// rounded. STL and 3MF take triangles only. Throws FileError, also for a mesh that no reader would
/// take.
void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh);
void write_mesh(std::ostream& out, FileFormat format, const PolygonMesh& mesh,
                std::string_view name);

/// What the numbers of a 3MF file count.
enum class LengthUnit { micrometer, millimeter, centimeter, inch, foot, meter };

/// Red, green and blue as screens have them.
using MeshColour = std::array<std::uint8_t, 3>;

struct NamedMesh {
  std::string name;  ///< UTF-8; may be empty, and need not be unique
  PolygonMesh mesh;
  /// Of all of it. Of a 3MF object without one: what most of its triangles have.
  std::optional<MeshColour> colour = {};
  bool has_more_colours = false;  ///< some triangles have others, which are not kept
};

/// Several meshes in one file.
struct Model {
  LengthUnit unit = LengthUnit::millimeter;
  std::vector<NamedMesh> meshes;
};

/// Reads all meshes of a file. In a 3MF file each item that is built is a mesh: components are
/// joined and moved to their places, each coordinate rounded once for each transform on its way,
/// and faces turned where a transform mirrors. Such a file holds floats, and numbers are not
/// changed for the unit's sake. Files of other formats hold one mesh without a name. Throws
/// FileError.
Model read_model(const std::filesystem::path& path);
Model read_model(std::istream& in, FileFormat format, std::string_view name);

/// Writes all meshes into one file as write_mesh() writes one. 3MF holds any number of them, and
/// coordinates up to a thousand million; the same model gives the same bytes. Other formats hold
/// just one and neither name, colour nor unit. Throws FileError.
void write_model(const std::filesystem::path& path, const Model& model);
void write_model(std::ostream& out, FileFormat format, const Model& model, std::string_view name);

/// All meshes as one soup. Throws FileError, in which `name` stands for the file, if there are more
/// positions than corners can count.
PolygonMesh joined(const Model& model, std::string_view name);

class WholeFile;

/// Files that appear all together or not at all.
class WholeFiles {
 public:
  WholeFiles();
  /// Removes whatever is not in its place.
  ~WholeFiles();
  WholeFiles(const WholeFiles&) = delete;
  WholeFiles& operator=(const WholeFiles&) = delete;

  /// Writes the content beside its place. Throws FileError.
  void add(const std::filesystem::path& path, std::string_view content);
  /// Puts all files into their places. Throws FileError; then nothing was changed.
  void place();

 private:
  std::vector<std::unique_ptr<WholeFile>> files_;
};

/// Puts `content` into a file so that the file appears whole or not at all. Throws FileError.
void write_whole(const std::filesystem::path& path, std::string_view content);

}  // namespace sectile
