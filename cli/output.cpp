#include "output.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>

#include "interrupt.h"
#include "problem.h"

namespace sectile::cli {
namespace {

namespace fs = std::filesystem;

bool is_standard(const std::string& name) {
  return name == "-";
}

[[noreturn]] void cannot_write(const std::string& name, const std::string& why) {
  throw FileError(name + ": cannot write: " + why);
}

// Devices and pipes must not be replaced by files.
bool is_special(const std::string& name) {
  std::error_code ignored;
  const fs::file_status status = fs::status(name, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

void check_place(const std::string& name) {
  std::error_code ignored;
  if (fs::is_directory(name, ignored)) cannot_write(name, "it is a directory");
  const fs::path folder = fs::path(name).parent_path();
  if (!folder.empty() && !fs::is_directory(folder, ignored))
    cannot_write(name, "there is no directory " + folder.string());
}

void write_stream(std::ostream& out, const std::string& name, const std::string& content) {
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.flush();
  if (!out) cannot_write(name, "the device or pipe takes no more");
}

void write_special(const Output& output) {
  if (is_standard(output.name)) {
    write_stream(std::cout, "standard output", output.content);
    return;
  }
  std::ofstream out(output.name, std::ios::binary);
  write_stream(out, output.name, output.content);
}

}  // namespace

void check_outputs(const std::vector<std::string>& names, const Options& options) {
  std::set<fs::path> seen;
  for (const std::string& name : names) {
    std::error_code ignored;
    if (!seen.insert(is_standard(name) ? fs::path(name)
                                       : fs::weakly_canonical(fs::absolute(name), ignored))
             .second)
      throw UsageError("two outputs have the same name: " + name);
    if (is_standard(name) && options.json)
      throw UsageError("--json and the output - both want standard output");
    if (!is_standard(name)) check_place(name);
  }
}

void check_mesh_outputs(const std::vector<std::string>& names, const Options& options) {
  for (const std::string& name : names) output_format(name, options);
  check_outputs(names, options);
}

FileFormat output_format(const std::string& name, const Options& options) {
  if (options.output_format) return *options.output_format;
  return is_standard(name) ? FileFormat::obj : format_of(name);
}

Output rendered(const std::string& name, const Model& model, const Options& options) {
  const FileFormat format = output_format(name, options);
  std::ostringstream out;
  out.exceptions(std::ios::badbit);  // a stream would hide that memory ran out
  write_model(out, format, model, name);
  return {name, std::move(out).str()};
}

void write_outputs(const std::vector<Output>& outputs) {
  std::optional<Deferral> deferral;
  WholeFiles files;
  std::vector<const Output*> special;
  for (const Output& output : outputs)
    if (is_standard(output.name) || is_special(output.name)) {
      special.push_back(&output);
    } else {
      if (!deferral) deferral.emplace();  // files beside their places would be left
      files.add(output.name, output.content);
    }
  if (deferral) deferral->check();
  // What went down a pipe cannot be taken back, so this must not follow a file in its place.
  for (const Output* output : special) write_special(*output);
  files.place();
}

bool uses_standard_output(const std::vector<std::string>& names) {
  return std::any_of(names.begin(), names.end(), is_standard);
}

}  // namespace sectile::cli
