// The readers and writers of the formats. Readers take a whole file; `name` is for messages.
#pragma once

#include <string_view>

#include "files/sink.h"
#include "sectile/files.h"

namespace sectile {

PolygonMesh read_obj(std::string_view content, std::string_view name);
PolygonMesh read_stl(std::string_view content, std::string_view name);
PolygonMesh read_off(std::string_view content, std::string_view name);
PolygonMesh read_ply(std::string_view content, std::string_view name);
Model read_three_mf(std::string_view content, std::string_view name);

// Writers take meshes that are consistent and finite.
void write_obj(Sink& out, const PolygonMesh& mesh);
void write_stl_text(Sink& out, const PolygonMesh& mesh, std::string_view name);
void write_stl_binary(Sink& out, const PolygonMesh& mesh, std::string_view name);
void write_off(Sink& out, const PolygonMesh& mesh);
/// The faces as OFF and PLY have them in text: a line each, the number of corners first.
void write_faces(Sink& out, const PolygonMesh& mesh);
void write_ply_text(Sink& out, const PolygonMesh& mesh);
void write_ply_binary(Sink& out, const PolygonMesh& mesh);
/// Any number of meshes, also none.
void write_three_mf(Sink& out, const Model& model, std::string_view name);

}  // namespace sectile
