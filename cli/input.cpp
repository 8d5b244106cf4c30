#include "input.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "file_formats.h"
#include "problem.h"
#include "repairing.h"
#include "sectile/exact_file.h"

namespace sectile::cli {
namespace {

bool is_standard(const std::string& name) {
  return name == "-";
}

bool has_known_extension(const std::string& name) {
  try {
    format_of(name);
    return true;
  } catch (const FileError&) {
    return false;
  }
}

std::string in_messages(const std::string& name) {
  return is_standard(name) ? "standard input" : name;
}

// A file without a single byte was cut off; files of empty solids have a header or a comment.
void require_content(const std::string& name) {
  std::error_code ignored;
  if (std::filesystem::is_directory(name, ignored))
    throw FileError(name + ": cannot read: it is a directory");
  if (std::filesystem::is_regular_file(name, ignored) &&
      std::filesystem::file_size(name, ignored) == 0)
    throw FileError(name + ":1: the file is empty");
}

struct NameParts {
  std::string file, part;
};

// A part can be asked for only of 3MF; other names may hold # as they like.
NameParts parts_of(const std::string& name) {
  std::error_code ignored;
  const std::size_t at = name.rfind('#');
  if (at == std::string::npos || std::filesystem::exists(name, ignored)) return {name, {}};
  const std::string file = name.substr(0, at);
  if (!has_known_extension(file) || format_of(file) != FileFormat::three_mf) return {name, {}};
  return {file, name.substr(at + 1)};
}

const NamedMesh& the_part(const Model& model, const std::string& file, const std::string& part) {
  const NamedMesh* found = nullptr;
  for (const NamedMesh& mesh : model.meshes) {
    if (mesh.name != part) continue;
    if (found != nullptr)
      throw FileError(file + ": several solids are named \"" + part + "\"; use their numbers");
    found = &mesh;
  }
  if (found != nullptr) return *found;
  std::size_t number = 0;
  const char* end = part.data() + part.size();
  if (std::from_chars(part.data(), end, number).ptr == end && number >= 1 &&
      number <= model.meshes.size())
    return model.meshes[number - 1];
  throw FileError(file + ": there is no solid \"" + part + "\"; sectile info lists all " +
                  std::to_string(model.meshes.size()));
}

Model read_file(const std::string& name, const Options& options) {
  if (is_standard(name)) {
    if (std::cin.peek() == std::istream::traits_type::eof())
      throw FileError("standard input:1: the file is empty");
    return read_model(std::cin, input_format(name, options), "standard input");
  }
  require_content(name);
  if (has_known_extension(name) || !options.input_format) return read_model(name);
  std::ifstream in(name, std::ios::binary);
  if (!in) throw FileError(name + ": cannot open");
  return read_model(in, *options.input_format, name);
}

// What an operation that failed leaves behind, to be done again.
bool is_exact_file(const std::string& name) {
  return std::filesystem::path(name).extension() == ".exact";
}

Solid read_exact_file(const std::string& name) {
  std::ifstream in(name, std::ios::binary);
  if (!in) throw FileError(name + ": cannot open");
  return read_exact(in, name);
}

}  // namespace

void check_inputs(const std::vector<std::string>& names) {
  const auto standard = std::count_if(names.begin(), names.end(), is_standard);
  if (standard > 1) throw UsageError("standard input (-) can be read only once");
}

FileFormat input_format(const std::string& name, const Options& options) {
  if (is_standard(name)) return options.input_format.value_or(FileFormat::obj);
  const std::string file = parts_of(name).file;
  if (options.input_format && !has_known_extension(file)) return *options.input_format;
  return format_of(file);
}

Model read_input(const std::string& name, const Options& options) {
  const auto [file, part] = parts_of(name);
  Model model = read_file(file, options);
  if (!part.empty()) model.meshes = {the_part(model, file, part)};
  return model;
}

std::string part_name(const std::string& name, std::size_t index, std::size_t count) {
  return !name.empty() || count == 1 ? name : std::to_string(index + 1);
}

Solid import_input(const std::string& name, const PolygonMesh& mesh, Progress& progress) {
  try {
    ImportOptions how;
    how.progress = [&](double done) { progress.fraction(done); };
    return Solid::from_mesh(mesh, how);
  } catch (const InvalidSolid& error) {
    throw IllegalInput(in_messages(name), problems_of(error));
  }
}

Operands read_operands(const std::vector<std::string>& names, const Options& options,
                       Progress& progress) {
  Operands operands{names, {}, LengthUnit::millimeter};
  std::optional<LengthUnit> unit;
  for (const std::string& name : names) {
    progress.stage("reading " + name);
    if (is_exact_file(name)) {
      operands.solids.push_back(read_exact_file(name));
      continue;
    }
    const Model model = read_input(name, options);
    if (input_format(name, options) == FileFormat::three_mf) {
      if (unit && *unit != model.unit)
        throw UsageError(name + " is in the unit " + name_of(model.unit) +
                         ", other operands are in the unit " + name_of(*unit));
      unit = model.unit;
    }
    const PolygonMesh mesh = joined(model, in_messages(name));
    if (!options.repair) {
      operands.solids.push_back(import_input(name, mesh, progress));
      continue;
    }
    progress.stage("repairing " + name);
    RepairOptions how;
    how.progress = [&](double done) { progress.fraction(done); };
    RepairReport report;
    operands.solids.push_back(repair_input(name, mesh, how, report));
    if (!options.quiet)
      for (const RepairChange& change : report.changes)
        std::cerr << "sectile: " << in_messages(name) << ": " << in_words(change) << '\n';
  }
  operands.unit = unit.value_or(LengthUnit::millimeter);
  return operands;
}

}  // namespace sectile::cli
