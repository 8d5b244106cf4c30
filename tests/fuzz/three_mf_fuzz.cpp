// Input that begins with "PK" is a package, all other is the XML of its model.
#include "fuzz/read_anything.h"
#include "unit/files/three_mf_package.h"

using namespace sectile;

// lib3mf's own leak, see tests/leaks.supp.
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libzip.so";
}

namespace {

// Coordinates of transforms are doubles; once they are floats, they stay.
void check_round_trip(const PolygonMesh& mesh) {
  const auto written = [](const PolygonMesh& m) {
    return fuzz::written([&](Sink& out) {
      write_three_mf(out, {LengthUnit::millimeter, {{{}, m}}}, "file");
    });
  };
  try {
    const PolygonMesh floats = joined(read_three_mf(written(mesh), "again"), "again");
    fuzz::require_same(floats, joined(read_three_mf(written(floats), "again"), "again"));
  } catch (const FileError& error) {
    fuzz::require(
        std::string_view(error.what()).find("no coordinates beyond") != std::string_view::npos,
        "what was read can be written");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::string content =
      input.starts_with("PK") ? std::string(input) : test::three_mf_package(input);
  const auto read = [](std::string_view package, std::string_view name) {
    return joined(read_three_mf(package, name), name);
  };
  return fuzz::read_anything(reinterpret_cast<const std::uint8_t*>(content.data()), content.size(),
                             read, check_round_trip);
}
