#include "story/break_point.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <vector>

namespace sectile::viewer {
namespace {

// "v12"
std::optional<TraceEntity> entity_named(const std::string& word) {
  using Kind = TraceEntity::Kind;
  TraceEntity entity;
  for (const Kind kind : {Kind::vertex, Kind::edge, Kind::face}) {
    entity.kind = kind;
    const char* end = word.data() + word.size();
    if (word.size() > 1 && word[0] == word_for(kind)[0] &&
        std::from_chars(word.data() + 1, end, entity.number).ptr == end)
      return entity;
  }
  return {};
}

bool concerns(const TraceEvent& event, int solid, const TraceEntity& entity) {
  const std::vector<TraceEntity> own = entities_of(event, solid);
  if (std::find(own.begin(), own.end(), entity) != own.end()) return true;
  // A null edge also concerns its ends and what it lies at.
  const auto* edge = std::get_if<NullEdgeEvent>(&event);
  if (edge == nullptr || edge->solid != solid) return false;
  return edge->from == entity || edge->to == entity || (edge->site && edge->site->at == entity);
}

std::string meeting_in(const TraceEvent& event) {
  if (const auto* contact = std::get_if<ContactEvent>(&event))
    return meeting_of(contact->a, contact->b);
  if (const auto* segment = std::get_if<SegmentEvent>(&event))
    return meeting_of(segment->a, segment->b);
  return {};
}

}  // namespace

BreakPoint::BreakPoint(const std::string& text) : text_(text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string w; in >> w;) words.push_back(w);
  if (words.size() == 1) either_ = entity_named(words[0]);
  if (words.size() == 2 && (words[0] == "A" || words[0] == "B"))
    entity_[words[0] == "A" ? 0 : 1] = entity_named(words[1]);
  if (words.size() == 3 && words[1] == "on") {
    turned_ = words[2] + " on " + words[0];
    const auto a = entity_named(words[0]), b = entity_named(words[2]);
    if (a && b) {
      entity_[0] = a;
      entity_[1] = b;
    }
  }
}

bool BreakPoint::matches(const TraceEvent& event) const {
  if (either_) return concerns(event, 0, *either_) || concerns(event, 1, *either_);
  if (entity_[0] || entity_[1])
    return (!entity_[0] || concerns(event, 0, *entity_[0])) &&
           (!entity_[1] || concerns(event, 1, *entity_[1]));
  if (kind_of(event) == text_) return true;
  const std::string meeting = meeting_in(event);
  return !meeting.empty() && (meeting == text_ || meeting == turned_);
}

}  // namespace sectile::viewer
