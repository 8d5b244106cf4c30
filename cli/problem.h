// What is wrong with an input, and the exceptions that carry it to main.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sectile/errors.h"
#include "sectile/validate.h"

namespace sectile::cli {

using Json = nlohmann::ordered_json;

/// One reason why a file is not a legal solid. Faces and vertices are counted from 0.
struct Problem {
  std::string reason;  ///< one word, for programs
  std::string message;
  std::optional<std::uint32_t> face, other_face, vertex;
  std::optional<Vec3> where;
};
/// One, or one for each two faces that meet as they cannot.
std::vector<Problem> problems_of(const InvalidSolid& error);
Problem problem_of(const Violation& violation);
std::string in_words(const Problem& problem);
Json to_json(const Problem& problem);

/// A file that does not hold a legal solid.
class IllegalInput : public Error {
 public:
  IllegalInput(std::string file, std::vector<Problem> problems);
  const std::string& file() const { return file_; }
  const std::vector<Problem>& problems() const { return problems_; }

 private:
  std::string file_;
  std::vector<Problem> problems_;
};

/// A command line that can be understood but makes no sense.
class UsageError : public Error {
 public:
  using Error::Error;
};

}  // namespace sectile::cli
