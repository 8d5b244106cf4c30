// A split is told as in section 3: the solid S, the plane SP, and what is above, on and below it.
// It is computed as S within a half-space; here the words of the one become those of the other.
#include <array>
#include <cctype>
#include <utility>

#include "story/step_texts.h"

namespace sectile::viewer {
namespace {

bool is_letter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

// Whole words only: "A" in "AinB" stays.
std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos;) {
    const std::size_t end = at + what.size();
    const bool whole = (at == 0 || !is_letter(text[at - 1]) || !is_letter(what.front())) &&
                       (end == text.size() || !is_letter(text[end]) || !is_letter(what.back()));
    if (!whole) {
      at = text.find(what, end);
      continue;
    }
    text.replace(at, what.size(), with);
    at = text.find(what, at + with.size());
  }
  return text;
}

// "face f3 of B", "f3 of B" and "edge …": the half-space has its plane alone.
std::string without_numbers_of_plane(std::string text) {
  for (const std::string kind : {"face ", "edge ", "vertex ", ""}) {
    const std::string tail = " of B";
    for (std::size_t at = text.find(tail); at != std::string::npos; at = text.find(tail, at + 1)) {
      std::size_t begin = at;
      while (begin > 0 && is_letter(text[begin - 1])) --begin;
      if (begin == at || begin < kind.size() ||
          text.compare(begin - kind.size(), kind.size(), kind) != 0)
        continue;
      text.replace(begin - kind.size(), at + tail.size() - begin + kind.size(), "the plane");
      at = 0;
    }
  }
  return text;
}

class Words {
 public:
  explicit Words(bool above)
      : kept_(above ? "Above" : "Below"), other_(above ? "Below" : "Above") {}

  std::string operator()(std::string text) const {
    text = without_numbers_of_plane(std::move(text));
    const std::array<std::pair<std::string, std::string>, 17> pairs{
        {{"Table I, row \u2229", "section 3"},
         {"AinB", kept_},
         {"AoutB", other_},
         {"AonB+", "the part on the plane"},
         {"AonB-", "the part on the plane"},
         {"BonA+", "the plane on S"},
         {"BonA-", "the plane on S"},
         {"BinA", "the plane in S"},
         {"BoutA", "the plane outside S"},
         {"A \u2229 B", kept_},
         {"of A", "of S"},
         {"from A", "from S"},
         {"A is cut", "S is cut"},
         {"sectors of A", "sectors of S"},
         {"of B", "of the plane"},
         {"outside B", "beyond the plane"},
         {"inside B", "on this side of the plane"}}};
    for (const auto& [what, with] : pairs) text = replaced(std::move(text), what, with);
    return text;
  }

  // A cell of a table: codes become those of section 3.
  std::string cell(const std::string& text) const {
    if (text == "in") return kept_ == "Above" ? "above" : "below";
    if (text == "out") return kept_ == "Above" ? "below" : "above";
    if (text == "on+" || text == "on-") return "on";
    if (text == "A") return "S";
    if (text == "B") return "plane";
    return (*this)(text);
  }

 private:
  std::string kept_, other_;
};

}  // namespace

void put_in_words_of_split(const StoryRecord& record, Step& step) {
  const Words words(record.split->above);
  step.title = words(step.title);
  step.words = words(step.words);
  step.verdict.words = words(step.verdict.words);
  for (std::string& bullet : step.bullets) bullet = words(bullet);
  for (Row& row : step.table)
    for (std::string& text : row) text = words.cell(text);
  const auto of_s = [](std::string& name) {
    if (name.starts_with("A ")) name[0] = 'S';
    if (name.starts_with("B ")) name = "plane";
  };
  for (std::string& name : step.row_faces) of_s(name);
  for (SpherePicture::Arc& arc : step.sphere.arcs) of_s(arc.label);
  for (SpherePicture::Mark& mark : step.sphere.marks) of_s(mark.label);
  for (PaperTable& table : step.paper)
    for (std::string& name : table.columns) name = words.cell(name);
}

}  // namespace sectile::viewer
