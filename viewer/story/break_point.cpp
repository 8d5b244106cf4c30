#include "story/break_point.h"

#include <algorithm>
#include <sstream>

namespace sectile::viewer {
namespace {

bool is_entity(const std::string& word) {
  return word.size() > 1 && (word[0] == 'v' || word[0] == 'e' || word[0] == 'f') &&
         std::all_of(word.begin() + 1, word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool has_word(const std::string& words, const std::string& word) {
  for (std::size_t at = words.find(word); at != std::string::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' '))
      return true;
  }
  return false;
}

bool concerns(const TraceEvent& event, int solid, const std::string& entity) {
  const std::string& names = solid == 0 ? event.a : event.b;
  if (has_word(names, entity)) return true;
  // A null edge also concerns its ends and what it lies at.
  if (event.kind != "null edge" || names.empty()) return false;
  return event.fact("from") == entity || event.fact("to") == entity || event.fact("at") == entity;
}

}  // namespace

BreakPoint::BreakPoint(const std::string& text) : text_(text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string w; in >> w;) words.push_back(w);
  if (words.size() == 1 && is_entity(words[0])) either_ = words[0];
  if (words.size() == 2 && is_entity(words[1]) && (words[0] == "A" || words[0] == "B"))
    entity_[words[0] == "A" ? 0 : 1] = words[1];
  if (words.size() == 3 && words[1] == "on") {
    turned_ = words[2] + " on " + words[0];
    if (is_entity(words[0]) && is_entity(words[2])) {
      entity_[0] = words[0];
      entity_[1] = words[2];
    }
  }
}

bool BreakPoint::matches(const TraceEvent& event) const {
  if (!either_.empty()) return concerns(event, 0, either_) || concerns(event, 1, either_);
  if (!entity_[0].empty() || !entity_[1].empty())
    return (entity_[0].empty() || concerns(event, 0, entity_[0])) &&
           (entity_[1].empty() || concerns(event, 1, entity_[1]));
  const std::string_view kind = event.fact("kind");
  return event.kind == text_ || (!kind.empty() && (kind == text_ || kind == turned_));
}

}  // namespace sectile::viewer
