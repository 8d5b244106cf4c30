// What is said about solids that were read or written, for people and for programs.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options.h"
#include "problem.h"
#include "sectile/rounding.h"
#include "sectile/solid.h"

namespace sectile::cli {

/// The shortest decimal that reads back as the same double.
std::string in_words(double value);
/// "1 shell", "2 shells".
std::string counted(std::size_t count, const std::string& what);
std::string counted(std::size_t count, const std::string& one, const std::string& many);

Json to_json(const Solid& solid);

/// A solid that was written as triangles.
struct Written {
  std::string file;
  Solid solid;
  std::size_t triangles = 0;
  RoundingReport rounding;
  std::string part;  ///< which of several solids in the file; may be empty
};
/// "file" or "file#part".
std::string name_of(const Written& written);
std::string in_words(const Written& written);
Json to_json(const Written& written);

/// Prints the summary of a command that wrote solids, as the options ask for.
void report(const std::string& command, const std::vector<std::string>& inputs,
            const std::vector<Written>& outputs, const Options& options);

}  // namespace sectile::cli
