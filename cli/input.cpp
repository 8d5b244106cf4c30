#include "input.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "problem.h"
#include "sectile/validate.h"

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

}  // namespace

void check_inputs(const std::vector<std::string>& names) {
  const auto standard = std::count_if(names.begin(), names.end(), is_standard);
  if (standard > 1) throw UsageError("standard input (-) can be read only once");
}

FileFormat input_format(const std::string& name, const Options& options) {
  if (is_standard(name)) return options.input_format.value_or(FileFormat::obj);
  if (options.input_format && !has_known_extension(name)) return *options.input_format;
  return format_of(name);
}

PolygonMesh read_input(const std::string& name, const Options& options) {
  if (is_standard(name)) {
    if (std::cin.peek() == std::istream::traits_type::eof())
      throw FileError("standard input:1: the file is empty");
    return read_mesh(std::cin, input_format(name, options), "standard input");
  }
  require_content(name);
  if (has_known_extension(name) || !options.input_format) return read_mesh(name);
  std::ifstream in(name, std::ios::binary);
  if (!in) throw FileError(name + ": cannot open");
  return read_mesh(in, *options.input_format, name);
}

Solid import_input(const std::string& name, const PolygonMesh& mesh, bool validate) {
  try {
    Solid solid = Solid::from_mesh(mesh);
    if (validate) require_legal(name, solid);
    return solid;
  } catch (const InvalidSolid& error) {
    throw IllegalInput(in_messages(name), {problem_of(error)});
  }
}

std::vector<Solid> read_solids(const std::vector<std::string>& names, const Options& options,
                               Progress& progress) {
  std::vector<Solid> solids;
  solids.reserve(names.size());
  for (const std::string& name : names) {
    progress.stage("reading " + name);
    solids.push_back(import_input(name, read_input(name, options), options.validate));
  }
  return solids;
}

void require_legal(const std::string& name, const Solid& solid) {
  const std::vector<Violation> violations = validate(solid);
  if (violations.empty()) return;
  std::vector<Problem> problems;
  for (const Violation& violation : violations) problems.push_back(problem_of(violation));
  throw IllegalInput(in_messages(name), std::move(problems));
}

}  // namespace sectile::cli
