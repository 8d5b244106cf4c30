#include "problem.h"

#include "json.h"
#include "summary.h"

namespace sectile::cli {
namespace {

constexpr std::size_t most_problems_in_words = 20;

const char* name_of(InvalidSolid::Reason reason) {
  switch (reason) {
    case InvalidSolid::Reason::malformed:
      return "malformed";
    case InvalidSolid::Reason::index_out_of_range:
      return "index_out_of_range";
    case InvalidSolid::Reason::not_finite:
      return "not_finite";
    case InvalidSolid::Reason::open:
      return "open";
    case InvalidSolid::Reason::inconsistent:
      return "inconsistent";
    case InvalidSolid::Reason::inside_out:
      return "inside_out";
    case InvalidSolid::Reason::self_intersecting:
      break;
  }
  return "self_intersecting";
}

std::optional<std::uint32_t> known(std::uint32_t element) {
  return element == no_element ? std::nullopt : std::optional(element);
}

std::string all_in_words(const std::string& file, const std::vector<Problem>& problems) {
  std::string text;
  for (std::size_t i = 0; i < problems.size() && i < most_problems_in_words; ++i)
    text += (i ? "\n" : "") + file + ": not a legal solid: " + in_words(problems[i]);
  if (problems.size() > most_problems_in_words)
    text += "\n" + file + ": and " + std::to_string(problems.size() - most_problems_in_words) +
            " more problems";
  return text;
}

}  // namespace

std::vector<Problem> problems_of(const InvalidSolid& error) {
  std::vector<Problem> problems;
  for (const FaceContact& c : error.contacts())
    problems.push_back({name_of(error.reason()), c.what, c.face, c.other, {}, c.where});
  if (problems.empty())
    problems.push_back({name_of(error.reason()),
                        error.what(),
                        known(error.face()),
                        {},
                        known(error.vertex()),
                        {}});
  return problems;
}

Problem problem_of(const Violation& violation) {
  Problem problem{"self_intersecting", violation.what, {}, {}, {}, {}};
  // The validator leaves the origin where it knows no place.
  if (violation.where != Vec3{}) problem.where = violation.where;
  return problem;
}

std::string in_words(const Problem& problem) {
  std::string text = problem.message;
  if (problem.where)
    text += " near (" + in_words(problem.where->x) + ", " + in_words(problem.where->y) + ", " +
            in_words(problem.where->z) + ")";
  return text;
}

Json to_json(const Problem& problem) {
  Json json{{"reason", problem.reason}, {"message", problem.message}};
  if (problem.face) json["face"] = *problem.face;
  if (problem.other_face) json["other_face"] = *problem.other_face;
  if (problem.vertex) json["vertex"] = *problem.vertex;
  if (problem.where) json["where"] = {problem.where->x, problem.where->y, problem.where->z};
  return json;
}

IllegalInput::IllegalInput(std::string file, std::vector<Problem> problems)
    : Error(all_in_words(file, problems)), file_(std::move(file)), problems_(std::move(problems)) {}

}  // namespace sectile::cli
