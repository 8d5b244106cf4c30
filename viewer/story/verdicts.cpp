// A step at a glance: three words and a colour, the row of the paper's table, at most three
// bullets.
#include <algorithm>
#include <array>
#include <set>

#include "story/paper_tables.h"
#include "story/step_texts.h"
#include "story/wording.h"

namespace sectile::viewer {
namespace {

using Tone = Verdict::Tone;

using Kind = TraceEntity::Kind;
struct ContactVerdict {
  Kind a, b;
  const char* words;
  const char* bullet;
};
// In the order of the steps of section 5.
constexpr std::array<ContactVerdict, 8> contact_verdicts = {{
    {Kind::edge, Kind::edge, "Two edges cross", "Both edges get a vertex here."},
    {Kind::edge, Kind::vertex, "Edge meets vertex", "The edge of A is divided here."},
    {Kind::vertex, Kind::edge, "Vertex meets edge", "The edge of B is divided here."},
    {Kind::vertex, Kind::vertex, "Two vertices coincide", "Nothing needs to be divided."},
    {Kind::edge, Kind::face, "Edge pierces face", "The edge of A is divided here."},
    {Kind::face, Kind::edge, "Edge pierces face", "The edge of B is divided here."},
    {Kind::vertex, Kind::face, "Vertex touches face", "The vertex of A stays as it is."},
    {Kind::face, Kind::vertex, "Vertex touches face", "The vertex of B stays as it is."},
}};

void judge_contact(const StoryRecord& record, const ContactEvent& event, Step& step) {
  const auto found = std::find_if(
      contact_verdicts.begin(), contact_verdicts.end(),
      [&](const ContactVerdict& v) { return v.a == event.a.kind && v.b == event.b.kind; });
  const auto row = static_cast<std::size_t>(found - contact_verdicts.begin());
  step.verdict = {found->words, step.special ? Tone::special : Tone::plain};
  PaperTable table = steps_of_reduction();
  table.lit_rows = {row};
  step.bullets = {capital(of_solid(0, event.a)) + " and " + of_solid(1, event.b) + ".",
                  found->bullet};
  const std::size_t here = record.contacts.at(event.place.number).size();
  step.bullets.push_back(here > 1 ? "Place " + std::to_string(event.place.number) + ": " +
                                        std::to_string(here) + " contacts meet here."
                                  : "Alone at place " + std::to_string(event.place.number) + ".");
  step.paper = {std::move(table)};
}

void judge_segment(const SegmentEvent& event, Step& step) {
  const bool edge_a = event.a.is_edge(), edge_b = event.b.is_edge();
  const char* figure = edge_a && edge_b   ? "Figure 16b."
                       : edge_a || edge_b ? "Figure 16a."
                                          : "Figure 14.";
  step.verdict = {edge_a && edge_b   ? "Two edges coincide"
                  : edge_a || edge_b ? "Edge within face"
                                     : "Two faces cross",
                  step.special ? Tone::special : Tone::plain};
  step.bullets = {"From place " + std::to_string(event.ends[0].number) + " to place " +
                      std::to_string(event.ends[1].number) + ".",
                  "What meets at one of its points meets at each.", figure};
}

// Row 4 of "Table II, row 4 (row 2 from the other end), …".
std::size_t number_after(const std::string& text, const std::string& what) {
  const std::size_t at = text.find(what);
  return at == std::string::npos ? 0 : static_cast<std::size_t>(std::atoi(&text[at + what.size()]));
}

void add_tables(const StoryRecord& record, const NeighborhoodEvent& event, const PaperRule& rule,
                Step& step) {
  if (const std::size_t row = number_after(rule.where, "Table II, row ")) {
    PaperTable table = table_2();
    table.lit_rows = {row - 1};
    // The same edge, seen from its other end.
    if (const std::size_t turned = number_after(rule.where, "(row "))
      table.lit_rows.push_back(turned - 1);
    step.paper.push_back(std::move(table));
  }
  if (rule.where.find("Table III") != std::string::npos) {
    PaperTable table = table_3();
    const bool identical = rule.where.find("identical") != std::string::npos;
    const bool a_first = rule.where.find("A against B") != std::string::npos;
    table.lit_rows = {(identical ? 0u : 2u) + (a_first ? 0u : 1u)};
    table.lit_columns = {record.operation == Operation::unite       ? 2u
                         : record.operation == Operation::intersect ? 4u
                                                                    : 3u};
    step.paper.push_back(std::move(table));
  }
  PaperTable table = record.split ? rules_of_splitting() : table_1();
  std::set<std::size_t> lit;
  for (const TraceHalfPlane& h : event.half_planes) {
    if (!is_on(h.before)) continue;
    const std::size_t against = h.before == TraceClass::on_plus ? 0 : 1;
    if (!record.split) lit.insert(1 + 2 * h.solid + against);
    // The half-space's own normal points out of it, against that of the plane.
    if (record.split && h.solid == 0) lit.insert(record.split->above ? 1 - against : against);
  }
  if (lit.empty()) return;
  if (record.split) {
    table.lit_rows.assign(lit.begin(), lit.end());
  } else {
    table.lit_rows = {row_of(record.operation)};
    table.lit_columns.assign(lit.begin(), lit.end());
  }
  step.paper.push_back(std::move(table));
}

std::string list_of(const std::set<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

void judge_neighborhood(const StoryRecord& record, const NeighborhoodEvent& event, Step& step) {
  std::set<std::string> cut, moved;
  bool cuts[2] = {false, false};
  for (const TraceHalfPlane& h : event.half_planes) {
    if (h.before != h.after)
      moved.insert(part_name(h.solid, h.before) + " goes to " + part_name(h.solid, h.after));
    if (!h.cut) continue;
    cuts[h.solid] = true;
    cut.insert(of_solid(h.solid, h.carrier));
  }
  const PaperRule rule = paper_rule(event, record.operation);
  step.verdict = cuts[0] && cuts[1] ? Verdict{"Both are cut", Tone::cut}
                 : cuts[0]          ? Verdict{"A is cut", Tone::cut}
                 : cuts[1]          ? Verdict{"B is cut", Tone::cut}
                                    : Verdict{"Nothing is cut", Tone::plain};
  const std::size_t end = rule.where.find(", Table III");
  step.bullets = {capital(rule.where.substr(0, end)) + "."};
  if (!moved.empty())
    step.bullets.push_back((record.split ? "Section 3: " : "Table I: ") + list_of(moved) + ".");
  step.bullets.push_back(cut.empty() ? "Each face keeps both of its sides together."
                                     : "Cut: " + list_of(cut) + ".");
  add_tables(record, event, rule, step);
}

void judge_null_edge(const StoryRecord& record, const NullEdgeEvent& event, Step& step) {
  const std::string ends = name_of(event.from) + " and " + name_of(event.to);
  step.verdict.tone = Tone::cut;
  if (!event.site) {
    step.verdict.words = "Corners are linked";
    step.bullets = {"A face touches itself here.", "The null edge links corners " + ends + "."};
    return;
  }
  const auto& [at, cuts] = *event.site;
  step.verdict.words = at.is_face() ? "Inner loop begins" : "Vertex falls apart";
  step.bullets = {counted(cuts, "cut") + (cuts == 1 ? " ends here." : " meet here."),
                  "One place, two vertices: " + ends + ".",
                  at.is_face()                                            ? "Figure 13."
                  : cuts > 2                                              ? "Figure 22."
                  : record.sight(event.place.number) != Sight::coincident ? "Figure 9."
                                                                          : "Figure 21."};
}

void judge_cut(const CutEvent& event, Step& step) {
  const bool across = event.carrier.is_face();
  step.verdict = {across ? "Face is cut" : "Edge is doubled", Tone::cut};
  step.bullets = {
      "The null edges of places " + std::to_string(event.ends[0].number) + " and " +
          std::to_string(event.ends[1].number) + " are joined.",
      across ? "Two new edges, one for each side." : "One new edge, beside the one that is there.",
      "Figure 10."};
}

void add_equation(const StoryRecord& record, Step& step) {
  if (record.split) return;
  PaperTable table = equation_of_parts();
  table.lit_rows = {row_of(record.operation)};
  step.paper = {std::move(table)};
}

void judge_part(const StoryRecord& record, const PartEvent& event, Step& step) {
  using Fate = PartEvent::Fate;
  step.verdict = event.fate == Fate::dropped ? Verdict{"Part is dropped", Tone::dropped}
                 : event.fate == Fate::kept  ? Verdict{"Part is kept", Tone::kept}
                                             : Verdict{"Kept, turned over", Tone::kept};
  step.bullets = {part_name(event.solid, event.side) + " has " + counted(event.faces, "face") +
                  "."};
  add_equation(record, step);
}

void judge_wedge(const StoryRecord& record, const WedgeEvent& event, Step& step) {
  step.verdict = {"Wedge is glued", Tone::kept};
  step.bullets = {"Between " + describe(event.between) + ".", "The wedge gets an edge of its own."};
  if (is_of_one_solid(event))
    step.bullets.push_back(std::string("Both sides come from ") +
                           (event.between[0].solid == 1 ? "B." : "A."));
  add_equation(record, step);
}

void judge_result(const StoryRecord& record, const ResultEvent& event, Step& step) {
  if (record.result.is_empty()) {
    step.verdict = {"Nothing is left", Tone::dropped};
    step.bullets = {formula(record.operation) + " is empty."};
    return;
  }
  step.verdict = {"Result is whole", Tone::kept};
  step.bullets = {
      "Edges within one face are gone.",
      counted(event.counts.faces, "face") + " in " + counted(event.counts.shells, "shell") + "."};
}

struct Judge {
  const StoryRecord& record;
  Step& step;
  void operator()(const ContactEvent& event) const { judge_contact(record, event, step); }
  void operator()(const SegmentEvent& event) const { judge_segment(event, step); }
  void operator()(const NeighborhoodEvent& event) const { judge_neighborhood(record, event, step); }
  void operator()(const NullEdgeEvent& event) const { judge_null_edge(record, event, step); }
  void operator()(const CutEvent& event) const { judge_cut(event, step); }
  void operator()(const PartEvent& event) const { judge_part(record, event, step); }
  void operator()(const WedgeEvent& event) const { judge_wedge(record, event, step); }
  void operator()(const ResultEvent& event) const { judge_result(record, event, step); }
};

}  // namespace

void judge(const StoryRecord& record, const TraceEvent& event, Step& step) {
  std::visit(Judge{record, step}, event);
}

}  // namespace sectile::viewer
