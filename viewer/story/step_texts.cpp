#include "story/step_texts.h"

#include "story/row_elements.h"
#include "story/sphere_picture.h"
#include "story/wording.h"

namespace sectile::viewer {
namespace {

// While contacts are being found, nothing is classified yet.
SpherePicture without_codes(SpherePicture sphere) {
  for (SpherePicture::Arc& arc : sphere.arcs) arc.cls.reset();
  for (SpherePicture::Mark& mark : sphere.marks) mark.cut = false;
  return sphere;
}

void tell_null_edge(const StoryRecord& record, const NullEdgeEvent& event, Step& step) {
  const std::string name = name_of(event.edge), from = name_of(event.from), to = name_of(event.to),
                    solid = event.solid == 0 ? "A" : "B";
  step.columns = {"null edge", "solid", "from", "to", "at", "cuts there"};
  step.table = {{name, solid, from, to, event.site ? name_of(event.site->at) : "corners that touch",
                 event.site ? std::to_string(event.site->cuts) : ""}};
  if (!event.site) {
    step.title = "null edge " + name + " of " + solid + " between corners that touch";
    step.words =
        "A face touches itself here, and several of its corners have cuts. The null edge " + name +
        " links them, so that each corner encloses nothing but one part of the face.";
    return;
  }
  const auto& [at, cuts] = *event.site;
  const std::string ends = "vertices " + from + " and " + to;
  const std::string where = of_solid(event.solid, at);
  step.title = "null edge " + name + " at " + where;
  if (at.is_face()) {
    step.words = "Inside " + where + " " + counted(cuts, "cut") +
                 " meet in one point. The point becomes " + ends +
                 ", with a side of the cuts for each; null edge " + name +
                 " between them has no length and begins an inner loop of the face (section 6.1, "
                 "figure 13).";
  } else {
    step.words = at.is_edge()
                     ? capital(where) + " is divided here, and the neighborhood of the new vertex"
                     : "The neighborhood of " + where;
    step.words +=
        " falls into " + counted(cuts, "run") + " of sectors, between its cuts. Null edge " + name +
        " joins " + ends + ", which have the same place: " +
        (record.sight(event.place.number) != Sight::coincident ? "section 6.1, as in figure 9."
                                                               : "section 6.2.3, figure 21.");
  }
  if (cuts != 1 && cuts != 2)
    step.words += " The " + std::to_string(cuts) +
                  " cuts need a chain of null edges; those within one sector "
                  "dangle (figure 22).";
}

void tell_cut(const StoryRecord& record, const CutEvent& event, Step& step) {
  const bool across = event.carrier.is_face();
  step.title = (across ? "cut across " : "cut beside ") + of_solid(event.solid, event.carrier);
  step.words = "The null edges at places " + std::to_string(event.ends[0].number) + " and " +
               std::to_string(event.ends[1].number) + " are joined by " +
               (across ? "two new edges across the face, one for each side of the cut."
                       : "a new edge beside the edge that is there, which stays with the face on "
                         "its other side.") +
               " Between the two sides a face without area remains, so that the surface stays "
               "closed until it falls apart.";
  step.columns = {"side", "face", "class", "reclassified", "becomes"};
  const NeighborhoodEvent* neighborhood = record.neighborhood(event.ends);
  if (!neighborhood) return;
  for (const TraceHalfPlane& h : neighborhood->half_planes)
    if (h.solid == event.solid && h.carrier == event.carrier)
      step.table.push_back({h.forward ? "forward" : "backward", "f" + std::to_string(h.face),
                            std::string(name_of(h.before)), std::string(name_of(h.after)),
                            h.kept ? "kept" : "dropped"});
}

void tell_part(const StoryRecord& record, const PartEvent& event, Step& step) {
  const std::string part = part_name(event.solid, event.side), becomes(name_of(event.fate)),
                    faces = std::to_string(event.faces);
  const std::string solid = event.solid == 0 ? "A" : "B", other = event.solid == 0 ? "B" : "A";
  step.title = part + ": " + becomes;
  step.words = "Along the cuts the surface of " + solid + " falls apart. " + part +
               " is what lies " + (event.side == TraceClass::in ? "inside " : "outside ") + other +
               ", with the parts on " + other + " that Table I adds; it has " + faces +
               (faces == "1" ? " face. It is " : " faces. It is ") + becomes + ". " +
               equation_4(record.operation);
  step.columns = {"part", "becomes", "faces"};
  step.table = {{part, becomes, faces}};
}

void tell_wedge(const StoryRecord& record, const WedgeEvent& event, Step& step) {
  const std::string between = describe(event.between);
  step.title = "wedge between " + between;
  step.words = "Around the segment between places " + std::to_string(event.ends[0].number) +
               " and " + std::to_string(event.ends[1].number) + " " + between +
               " bound one wedge of the material of " + formula(record.operation) +
               ". They are glued along the segment, and the wedge gets an edge of its own.";
  if (is_of_one_solid(event))
    step.words += std::string(" Both come from ") + (event.between[0].solid == 1 ? "B" : "A") +
                  ": the wedge parts from others that touch it here.";
  step.columns = {"solid", "face", "class", "reclassified", "becomes"};
  const NeighborhoodEvent* neighborhood = record.neighborhood(event.ends);
  if (!neighborhood) return;
  for (const TraceHalfPlane& h : neighborhood->half_planes)
    step.table.push_back({h.solid == 0 ? "A" : "B", "f" + std::to_string(h.face),
                          std::string(name_of(h.before)), std::string(name_of(h.after)),
                          h.kept ? "kept" : "dropped"});
}

void tell_result(const StoryRecord& record, const ResultEvent& event, Step& step) {
  const SolidCounts& c = event.counts;
  step.title = "result: " + formula(record.operation);
  if (record.result.is_empty()) {
    step.words = "Nothing is left: " + formula(record.operation) + " is empty.";
  } else {
    step.words =
        "Edges between parts of one and the same face, and vertices in the middle of "
        "straight edges, have been removed. " +
        formula(record.operation) + " has " + counted(c.vertices, "vertex") + ", " +
        counted(c.edges, "edge") + " and " + counted(c.faces, "face") + " in " +
        counted(c.shells, "shell") + ".";
  }
  step.columns = {"count", "value"};
  step.table = {{"vertices", std::to_string(c.vertices)}, {"edges", std::to_string(c.edges)},
                {"faces", std::to_string(c.faces)},       {"loops", std::to_string(c.loops)},
                {"shells", std::to_string(c.shells)},     {"genus", std::to_string(c.genus)}};
}

struct Teller {
  const StoryRecord& record;
  Step& step;
  void operator()(const ContactEvent& event) const { tell_contact(record, event, step); }
  void operator()(const SegmentEvent& event) const { tell_segment(event, step); }
  void operator()(const NeighborhoodEvent& event) const { tell_neighborhood(record, event, step); }
  void operator()(const NullEdgeEvent& event) const { tell_null_edge(record, event, step); }
  void operator()(const CutEvent& event) const { tell_cut(record, event, step); }
  void operator()(const PartEvent& event) const { tell_part(record, event, step); }
  void operator()(const WedgeEvent& event) const { tell_wedge(record, event, step); }
  void operator()(const ResultEvent& event) const { tell_result(record, event, step); }
};

}  // namespace

Step tell_step(const StoryRecord& record, std::size_t number) {
  const TraceEvent& event = record.event(number);
  Step step;
  step.phase = record.steps[number].phase;
  step.special = record.steps[number].special;
  step.kind = kind_of(event);
  step.a = names_of(event, 0);
  step.b = names_of(event, 1);
  for (const TracePlace& place : places_of(event)) step.places.push_back(to_glm(place.point));
  std::visit(Teller{record, step}, event);
  judge(record, event, step);
  for (std::size_t row = 0; row < step.table.size(); ++row) {
    const std::optional<RowElement> element = element_of_row(record, number, row);
    step.row_faces.push_back(element ? element->name : "");
  }
  if (has_place(event)) step.sphere = sphere_at(record, record.main_place(event));
  if (step.phase == Phase::reduction) step.sphere = without_codes(std::move(step.sphere));
  if (record.split) put_in_words_of_split(record, step);
  return step;
}

}  // namespace sectile::viewer
