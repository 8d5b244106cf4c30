#include "story/step_texts.h"

#include <stdexcept>

#include "story/sphere_picture.h"
#include "story/wording.h"

namespace sectile::viewer {
namespace {

using Kind = std::string_view;

void tell_event(const StoryRecord& record, const TraceEvent& event, Step& step) {
  const Kind kind = event.kind;
  if (kind == "contact") return tell_contact(record, event, step);
  if (kind == "segment") return tell_segment(event, step);
  if (kind == "neighborhood") return tell_neighborhood(record, event, step);
  if (kind == "null edge") return tell_null_edge(record, event, step);
  if (kind == "cut") return tell_cut(record, event, step);
  if (kind == "part") return tell_part(record, event, step);
  if (kind == "wedge") return tell_wedge(record, event, step);
  if (kind == "result") return tell_result(record, event, step);
  throw std::logic_error("an unknown kind of event: " + event.kind);
}

// While contacts are being found, nothing is classified yet.
SpherePicture without_codes(SpherePicture sphere) {
  for (SpherePicture::Arc& arc : sphere.arcs) arc.code.clear();
  for (SpherePicture::Mark& mark : sphere.marks) mark.code.clear();
  return sphere;
}

}  // namespace

Step tell_step(const StoryRecord& record, std::size_t number) {
  const TraceEvent& event = record.event(number);
  Step step;
  step.phase = record.steps[number].phase;
  step.special = record.steps[number].special;
  step.kind = event.kind;
  step.a = event.a;
  step.b = event.b;
  for (const Vec3& p : event.points) step.places.push_back(to_glm(p));
  tell_event(record, event, step);
  if (!event.places.empty()) step.sphere = sphere_at(record, record.main_place(event));
  if (step.phase == Phase::reduction) step.sphere = without_codes(std::move(step.sphere));
  return step;
}

void tell_null_edge(const StoryRecord& record, const TraceEvent& event, Step& step) {
  const int solid = event.a.empty() ? 1 : 0;
  const std::string name = solid == 0 ? event.a : event.b;
  const std::string from(event.fact("from")), to(event.fact("to")), at(event.fact("at")),
      cuts(event.fact("cuts there"));
  step.columns = {"null edge", "solid", "from", "to", "at", "cuts there"};
  step.table = {
      {name, solid == 0 ? "A" : "B", from, to, at.empty() ? "corners that touch" : at, cuts}};
  if (at.empty()) {
    step.title =
        "null edge " + name + " of " + (solid == 0 ? "A" : "B") + " between corners that touch";
    step.words =
        "A face touches itself here, and several of its corners have cuts. The null edge " + name +
        " links them, so that each corner encloses nothing but one part of the face.";
    return;
  }
  const std::string ends = "vertices " + from + " and " + to;
  step.title = "null edge " + name + " at " + of_solid(solid, at);
  if (at[0] == 'f') {
    step.words = "Inside " + of_solid(solid, at) + " " + counted(cuts, "cut") +
                 " meet in one point. The point becomes " + ends +
                 ", with a side of the cuts for each; null edge " + name +
                 " between them has no length and begins an inner loop of the face (section 6.1, "
                 "figure 13).";
  } else {
    step.words = at[0] == 'e' ? capital(of_solid(solid, at)) +
                                    " is divided here, and the neighborhood of the new vertex"
                              : "The neighborhood of " + of_solid(solid, at);
    step.words +=
        " falls into " + counted(cuts, "run") + " of sectors, between its cuts. Null edge " + name +
        " joins " + ends + ", which have the same place: " +
        (record.sight(event.places[0]) != Sight::coincident ? "section 6.1, as in figure 9."
                                                            : "section 6.2.3, figure 21.");
  }
  if (cuts != "1" && cuts != "2")
    step.words += " The " + cuts +
                  " cuts need a chain of null edges; those within one sector "
                  "dangle (figure 22).";
}

void tell_cut(const StoryRecord& record, const TraceEvent& event, Step& step) {
  const int solid = event.a.empty() ? 1 : 0;
  const std::string& name = solid == 0 ? event.a : event.b;
  const bool across = name[0] == 'f';
  step.title = (across ? "cut across " : "cut beside ") + of_solid(solid, name);
  step.words = "The null edges at places " + std::to_string(event.places[0]) + " and " +
               std::to_string(event.places[1]) + " are joined by " +
               (across ? "two new edges across the face, one for each side of the cut."
                       : "a new edge beside the edge that is there, which stays with the face on "
                         "its other side.") +
               " Between the two sides a face without area remains, so that the surface stays "
               "closed until it falls apart.";
  step.columns = {"side", "face", "class", "reclassified", "becomes"};
  const TraceEvent* neighborhood = record.neighborhood(event.places[0], event.places[1]);
  if (!neighborhood) return;
  for (const TraceHalfPlane& h : neighborhood->half_planes)
    if (h.solid == solid && h.carrier == name)
      step.table.push_back({h.forward ? "forward" : "backward", "f" + std::to_string(h.face),
                            std::string(h.before), std::string(h.after),
                            h.kept ? "kept" : "dropped"});
}

void tell_part(const StoryRecord& record, const TraceEvent& event, Step& step) {
  const std::string part(event.fact("part")), becomes(event.fact("becomes"));
  const std::string solid = part.substr(0, 1), other = part.substr(part.size() - 1);
  const bool inside = part.find("in") != std::string::npos;
  step.title = part + ": " + becomes;
  step.words = "Along the cuts the surface of " + solid + " falls apart. " + part +
               " is what lies " + (inside ? "inside " : "outside ") + other +
               ", with the parts on " + other + " that Table I adds; it has " +
               std::string(event.fact("faces")) + " faces. It is " + becomes + ". " +
               equation_4(record.operation);
  step.columns = {"part", "becomes", "faces"};
  step.table = {{part, becomes, std::string(event.fact("faces"))}};
}

void tell_wedge(const StoryRecord& record, const TraceEvent& event, Step& step) {
  const std::string between(event.fact("between"));
  const bool one_solid = event.a.empty() || event.b.empty();
  step.title = "wedge between " + between;
  step.words = "Around the segment between places " + std::to_string(event.places[0]) + " and " +
               std::to_string(event.places[1]) + " " + between +
               " bound one wedge of the material of " + formula(record.operation) +
               ". They are glued along the segment, and the wedge gets an edge of its own.";
  if (one_solid)
    step.words += std::string(" Both come from ") + (event.a.empty() ? "B" : "A") +
                  ": the wedge parts from others that touch it here.";
  step.columns = {"solid", "face", "class", "reclassified", "becomes"};
  const TraceEvent* neighborhood = record.neighborhood(event.places[0], event.places[1]);
  if (!neighborhood) return;
  for (const TraceHalfPlane& h : neighborhood->half_planes)
    step.table.push_back({h.solid == 0 ? "A" : "B", "f" + std::to_string(h.face),
                          std::string(h.before), std::string(h.after),
                          h.kept ? "kept" : "dropped"});
}

void tell_result(const StoryRecord& record, const TraceEvent& event, Step& step) {
  step.title = "result: " + formula(record.operation);
  const auto number = [&](const char* name, const char* one) {
    return counted(event.fact(name), one);
  };
  if (record.result.is_empty()) {
    step.words = "Nothing is left: " + formula(record.operation) + " is empty.";
  } else {
    step.words =
        "Edges between parts of one and the same face, and vertices in the middle of "
        "straight edges, have been removed. " +
        formula(record.operation) + " has " + number("vertices", "vertex") + ", " +
        number("edges", "edge") + " and " + number("faces", "face") + " in " +
        number("shells", "shell") + ".";
  }
  step.columns = {"count", "value"};
  for (const auto& [name, value] : event.facts) step.table.push_back({name, value});
}

}  // namespace sectile::viewer
