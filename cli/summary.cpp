#include "summary.h"

#include <charconv>
#include <iostream>

#include "json.h"
#include "output.h"

namespace sectile::cli {

std::string in_words(double value) {
  char buffer[40];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr};
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string counted(std::size_t count, const std::string& what) {
  return counted(count, what, what + "s");
}

Json to_json(const Solid& solid) {
  const SolidCounts counts = solid.counts();
  return {{"vertices", counts.vertices}, {"edges", counts.edges},   {"faces", counts.faces},
          {"loops", counts.loops},       {"shells", counts.shells}, {"genus", counts.genus},
          {"volume", solid.volume()},    {"area", solid.area()}};
}

std::string name_of(const Written& written) {
  return written.part.empty() ? written.file : written.file + "#" + written.part;
}

std::string in_words(const Written& written) {
  const SolidCounts counts = written.solid.counts();
  const RoundingReport& rounding = written.rounding;
  std::string text = name_of(written) + ": " + counted(counts.vertices, "vertex", "vertices") +
                     ", " + counted(counts.faces, "face") + ", " +
                     counted(written.triangles, "triangle") + ", volume " +
                     in_words(written.solid.volume()) + ", area " + in_words(written.solid.area()) +
                     ", " + counted(counts.shells, "shell");
  if (rounding.moved > 0)
    text += "; " + counted(rounding.moved, "corner") + " rounded, by " +
            in_words(rounding.largest_move) + " at most";
  if (rounding.separated > 0)
    text += "; " + counted(rounding.separated, "corner") + " separated from others";
  if (rounding.resolved > 0)
    text += "; faces that could not be kept apart in the numbers of the file were united";
  return text;
}

Json to_json(const Written& written) {
  Json json{{"file", written.file}};
  if (!written.part.empty()) json["part"] = written.part;
  json.update(to_json(written.solid));
  json["triangles"] = written.triangles;
  const RoundingReport& rounding = written.rounding;
  json["rounding"] = {{"moved", rounding.moved},
                      {"displaced", rounding.displaced},
                      {"merged", rounding.merged},
                      {"flipped", rounding.flipped},
                      {"separated", rounding.separated},
                      {"resolved", rounding.resolved},
                      {"largest_move", rounding.largest_move},
                      {"median_move", rounding.median_move}};
  return json;
}

void report(const std::string& command, const std::vector<std::string>& inputs,
            const std::vector<Written>& outputs, const Options& options) {
  std::vector<std::string> names;
  for (const Written& output : outputs) names.push_back(output.file);
  if (options.json) {
    Json json{{"command", command}, {"exit_code", 0}, {"inputs", inputs}};
    for (const Written& output : outputs) json["outputs"].push_back(to_json(output));
    std::cout << json.dump() << '\n';
  }
  if (options.quiet) return;
  for (const Written& output : outputs)
    if (output.solid.is_empty())
      std::cerr << "sectile: " << name_of(output) << ": the result is empty\n";
  if (options.json) return;
  std::ostream& out = uses_standard_output(names) ? std::cerr : std::cout;
  for (const Written& output : outputs) out << in_words(output) << '\n';
}

}  // namespace sectile::cli
