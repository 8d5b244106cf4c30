// Repairs meshes and prints a row of a table for each: repair_table FILE...
#include <tbb/parallel_for.h>

#include <atomic>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>

#include "real/exact_winding.h"
#include "real/winding_check.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

// Of all cores together: the machine may be busy with other work.
double processor_time() {
  return 1e3 * double(std::clock()) / CLOCKS_PER_SEC;
}

using Kind = RepairChange::Kind;

std::string in_short(const RepairReport& report) {
  std::string text;
  for (const RepairChange& change : report.changes) {
    if (!text.empty()) text += ", ";
    std::string name = name_of(change.kind);
    for (char& c : name)
      if (c == '_') c = ' ';
    text += std::to_string(change.count) + " " + name;
  }
  return text.empty() ? "nothing" : text;
}

bool has(const RepairReport& report, Kind kind) {
  for (const RepairChange& change : report.changes)
    if (change.kind == kind) return true;
  return false;
}

// Where faces were turned or added, the winding numbers of the mesh as it is say nothing.
std::string agreement(const PolygonMesh& mesh, const RepairReport& report, const Solid& solid) {
  if (has(report, Kind::turned_faces) || has(report, Kind::closed_holes) ||
      has(report, Kind::split_polygons))
    return "-";
  const ExactWinding input(mesh), output(solid.to_mesh());
  const bool turned = has(report, Kind::turned_parts);
  const std::vector<Vec3> points = sample_points(mesh, 1000);
  std::atomic<int> wrong{0}, on_faces{0};
  tbb::parallel_for(std::size_t(0), points.size(), [&](std::size_t i) {
    const auto mine = input(points[i]), its = output(points[i]);
    if (!mine || !its)
      ++on_faces;
    else
      wrong += ((turned ? -*mine : *mine) >= 1) != (*its == 1);
  });
  return std::to_string(int(points.size()) - wrong - on_faces) + " of " +
         std::to_string(points.size()) +
         (on_faces > 0 ? ", " + std::to_string(on_faces) + " on faces" : "") +
         (wrong > 0 ? " **" + std::to_string(wrong) + " WRONG**" : "");
}

std::string before(const PolygonMesh& mesh) {
  try {
    Solid::from_mesh(mesh);
    return "taken";
  } catch (const InvalidSolid& error) {
    switch (error.reason()) {
      case InvalidSolid::Reason::open:
        return "open";
      case InvalidSolid::Reason::inconsistent:
        return "inconsistent";
      case InvalidSolid::Reason::inside_out:
        return "inside out";
      case InvalidSolid::Reason::self_intersecting:
        return "crosses itself";
      default:
        return "refused";
    }
  }
}

void print_row(const std::string& file) {
  const std::string name = std::filesystem::path(file).filename().string();
  PolygonMesh mesh;
  try {
    mesh = read_mesh(file);
  } catch (const FileError& error) {
    std::cout << "| " << name << " | | not read: " << error.what() << " | | | | |\n";
    return;
  }
  std::cout << "| " << name << " | " << mesh.face_sizes.size() << " | " << before(mesh) << " | "
            << std::flush;
  RepairReport report;
  RepairOptions options;
  Solid solid;
  double start = processor_time();
  bool legal = true;
  try {
    try {
      solid = repair(mesh, options, &report);
    } catch (const InvalidSolid& error) {
      if (error.reason() != InvalidSolid::Reason::open) throw;
      options.close_holes = true;
      start = processor_time();
      solid = repair(mesh, options, &report);
    }
  } catch (const Error& error) {
    std::cout << "refused: " << error.what() << " | | | |" << std::endl;
    return;
  }
  const double ms = processor_time() - start;
  legal = validate(solid).empty();
  char time[32];
  std::snprintf(time, sizeof time, "%.1f", ms);
  std::cout << in_short(report) << " | " << solid.counts().faces << (legal ? "" : " **ILLEGAL**")
            << " | " << time << " | " << agreement(mesh, report, solid) << " |" << std::endl;
}

}  // namespace
}  // namespace sectile::test

int main(int count, char** names) {
  std::cout
      << "| mesh | faces | as it is | repair | faces of the solid | ms | points that agree |\n"
         "|---|---|---|---|---|---|---|\n";
  for (int i = 1; i < count; ++i) sectile::test::print_row(names[i]);
}
