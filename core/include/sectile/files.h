// Reading and writing meshes: OBJ, STL (text and binary), OFF, PLY.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>
#include <string_view>

#include "sectile/mesh.h"

namespace sectile {

enum class FileFormat { obj, stl_text, stl_binary, off, ply_text, ply_binary };

/// The format a file name's extension stands for (".stl" is binary, ".ply" is text when written).
/// Throws FileError for an unknown extension.
FileFormat format_of(const std::filesystem::path& path);

/// Reads a mesh. STL and PLY files tell by themselves whether they are text or binary. Coordinates
/// are rounded correctly; polygons of any size are kept; nothing is dropped silently.
/// Throws FileError (the message starts with "NAME:LINE: " or "NAME: byte N: ").
PolygonMesh read_mesh(const std::filesystem::path& path);
PolygonMesh read_mesh(std::istream& in, FileFormat format, std::string_view name);

/// Writes a mesh. The file appears whole or not at all. Coordinates are written so that they read
/// back as the same doubles, except in binary STL, which holds floats: there they are rounded. STL
/// takes triangles only. Throws FileError, also for a mesh that no reader would take.
void write_mesh(const std::filesystem::path& path, const PolygonMesh& mesh);
void write_mesh(std::ostream& out, FileFormat format, const PolygonMesh& mesh,
                std::string_view name);

/// Puts `content` into a file so that the file appears whole or not at all. Throws FileError.
void write_whole(const std::filesystem::path& path, std::string_view content);

}  // namespace sectile
