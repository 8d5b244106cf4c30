#include "fuzz/read_anything.h"

using namespace sectile;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return fuzz::read_anything(data, size, read_ply, [](const PolygonMesh& mesh) {
    fuzz::require_same(
        mesh, read_ply(fuzz::written([&](Sink& out) { write_ply_text(out, mesh); }), "again"));
    fuzz::require_same(
        mesh, read_ply(fuzz::written([&](Sink& out) { write_ply_binary(out, mesh); }), "again"));
  });
}
