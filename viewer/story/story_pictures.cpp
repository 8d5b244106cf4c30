#include "story/story_pictures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <span>

#include "picture/theme.h"
#include "story/exploded_parts.h"
#include "story/neighborhood_mesh.h"

namespace sectile::viewer {
namespace {

constexpr std::size_t no_step = std::numeric_limits<std::size_t>::max();
constexpr std::size_t most_labels = 60;
// So many places show their sectors at once; more would hide each other.
constexpr std::size_t most_fans = 48;

double length_of(const TraceEvent& segment) {
  const std::span<const TracePlace> ends = places_of(segment);
  return glm::length(to_glm(ends[1].point) - to_glm(ends[0].point));
}

double shortest_segment_at(const StoryRecord& record, std::uint32_t place) {
  double shortest = std::numeric_limits<double>::max();
  for (const std::uint32_t i : record.neighborhoods.at(place))
    shortest = std::min(shortest, length_of(record.events[i]));
  return shortest;
}

// How large a neighborhood is drawn: not larger than its segments, but to be seen in any case.
double neighborhood_size(const StoryRecord& record, const TraceEvent& event) {
  const double scene = record.bounds.radius();
  double shortest = 0.3 * scene;
  for (const TracePlace& place : places_of(event))
    shortest = std::min(shortest, shortest_segment_at(record, place.number));
  return std::clamp(0.45 * shortest, 0.01 * scene, 0.18 * scene);
}

class Painter {
 public:
  Painter(const StoryRecord& record, Phase phase, std::size_t current, const StoryView& view)
      : record_(record),
        phase_(phase),
        first_(record.first_step[static_cast<std::size_t>(phase)]),
        last_(record.first_step[static_cast<std::size_t>(phase) + 1]),
        current_(current),
        view_(view),
        theme_(theme(view.dark)) {
    picture_.surroundings = theme_.surroundings;
  }

  Picture run() {
    switch (phase_) {
      case Phase::reduction:
        paint_reduction();
        break;
      case Phase::vertex_face:
      case Phase::vertex_vertex:
        paint_neighborhoods();
        break;
      case Phase::null_edges:
        paint_null_edges();
        break;
      case Phase::joining:
        paint_joining();
        break;
      case Phase::components:
        paint_components();
        break;
      case Phase::gluing:
        paint_gluing();
        break;
      case Phase::cleanup:
        paint_cleanup();
        break;
    }
    paint_labels();
    return std::move(picture_);
  }

 private:
  // Steps before the current one.
  std::size_t done() const { return current_ == no_step ? first_ : current_; }
  const TraceEvent* current() const {
    return current_ == no_step ? nullptr : &record_.event(current_);
  }
  Colour faint(Colour colour) const { return fainter(colour, theme_, 0.4f); }

  void paint_operands(bool as_wires) {
    for (int s = 0; s < 2; ++s) {
      Surface surface;
      surface.mesh = record_.operand(s);
      surface.colour = s == 0 ? theme_.a : theme_.b;
      surface.translucent = !as_wires;
      surface.faces = !as_wires;
      picture_.surfaces.push_back(surface);
    }
  }

  static void add_segment(Lines& lines, const TraceEvent& event) {
    for (const TracePlace& p : places_of(event)) lines.ends.push_back(glm::vec3(to_glm(p.point)));
  }

  Lines lines(Colour colour, float width) const {
    Lines made;
    made.colour = colour;
    made.width = width;
    made.on_top = true;
    return made;
  }
  Points points(Colour colour, float size) const {
    Points made;
    made.colour = colour;
    made.size = size;
    return made;
  }
  void add(Lines made) {
    if (!made.ends.empty()) picture_.lines.push_back(std::move(made));
  }
  void add(Points made) {
    if (!made.places.empty()) picture_.points.push_back(std::move(made));
  }

  void highlight(const TraceEvent& event, float width = 5) {
    const std::span<const TracePlace> places = places_of(event);
    if (places.size() == 2) {
      Lines made = lines(theme_.step, width);
      add_segment(made, event);
      add(made);
    }
    Points ends = points(theme_.step, places.size() == 1 ? 13.0f : 8.0f);
    for (const TracePlace& p : places) ends.places.push_back(glm::vec3(to_glm(p.point)));
    add(ends);
  }

  void paint_reduction() {
    paint_operands(false);
    paint_contacts(first_, done());
    if (current()) highlight(*current());
  }

  // What the phases after the first start from, where they find nothing to do.
  void paint_all_contacts() { paint_contacts(record_.first_step[0], record_.first_step[1]); }

  void paint_contacts(std::size_t from, std::size_t to) {
    // Vertices that coincide; vertices in faces; edges through faces.
    Points coincident = points(faint(theme_.coincident), 8),
           in_face = points(faint(theme_.contact), 8), through = points(faint(theme_.contact), 5);
    Lines across = lines(faint(theme_.contact_segment), 1.5f),
          along = lines(faint(theme_.coincident), 2.5f);
    for (std::size_t i = from; i < to; ++i) {
      const TraceEvent& event = record_.event(i);
      if (const auto* segment = std::get_if<SegmentEvent>(&event)) {
        add_segment(segment->a.is_face() && segment->b.is_face() ? across : along, event);
        continue;
      }
      const auto& contact = std::get<ContactEvent>(event);
      const bool face = contact.a.is_face() || contact.b.is_face(),
                 edge = contact.a.is_edge() || contact.b.is_edge();
      (!face  ? coincident
       : edge ? through
              : in_face)
          .places.push_back(glm::vec3(to_glm(contact.place.point)));
    }
    add(across);
    add(along);
    add(through);
    add(in_face);
    add(coincident);
  }

  Colour class_colour(int solid, std::optional<TraceClass> cls) const {
    const bool a = solid == 0;
    if (!cls) return with_alpha(theme_.neutral, 0.8f);
    switch (*cls) {
      case TraceClass::in:
        return a ? theme_.a_in_b : theme_.b_in_a;
      case TraceClass::out:
        return a ? theme_.a_out_b : theme_.b_out_a;
      case TraceClass::on_plus:
        return a ? theme_.a_on_b_plus : theme_.b_on_a_plus;
      case TraceClass::on_minus:
        break;
    }
    return a ? theme_.a_on_b_minus : theme_.b_on_a_minus;
  }

  void paint_classes(const ClassMeshes& meshes, float alpha, bool edges) {
    for (const auto& [key, mesh] : meshes) {
      Surface surface;
      surface.mesh = mesh;
      surface.colour = with_alpha(class_colour(key.first, key.second), alpha);
      surface.translucent = true;
      surface.edges = edges;
      picture_.surfaces.push_back(surface);
    }
  }

  void paint_neighborhoods() {
    paint_operands(true);
    if (!current()) return paint_all_contacts();
    const TraceEvent& event = *current();
    const std::uint32_t here = record_.main_place(event);
    Lines before = lines(faint(theme_.contact_segment), 1.5f);
    std::set<std::uint32_t> places{here};
    ClassMeshes earlier;
    for (std::size_t i = done(); i-- > first_;) {
      const TraceEvent& other = record_.event(i);
      add_segment(before, other);
      const std::uint32_t place = record_.main_place(other);
      if (places.size() < most_fans && places.insert(place).second)
        add_fans(record_, place, 0.8 * neighborhood_size(record_, other), earlier);
    }
    add(before);
    const double size = neighborhood_size(record_, event);
    ClassMeshes meshes;
    add_fans(record_, here, size, meshes);
    add_strips(std::get<NeighborhoodEvent>(event), 0.5 * size, 1.15 * size, meshes);
    paint_classes(earlier, 0.4f, false);
    paint_classes(meshes, 0.75f, true);
    highlight(event, 3);
  }

  // How far the ends of a null edge are drawn from their common place.
  double pull(const NullEdgeEvent& event) const {
    const double scene = record_.bounds.radius();
    const double room = event.site ? 0.5 * shortest_segment_at(record_, event.place.number) : 0;
    return std::clamp(room, 0.02 * scene, 0.16 * scene) * (0.75 + 0.25 * view_.exploded);
  }

  void add_null_edge(const TraceEvent& event, Lines& edge, Points& from, Points& to) const {
    const auto& null_edge = std::get<NullEdgeEvent>(event);
    const glm::dvec3 place = to_glm(null_edge.place.point);
    const double by = pull(null_edge);
    const glm::vec3 ends[2] = {glm::vec3(place + to_glm(null_edge.pulls[0]) * by),
                               glm::vec3(place + to_glm(null_edge.pulls[1]) * by)};
    edge.ends.insert(edge.ends.end(), ends, ends + 2);
    from.places.push_back(ends[0]);
    to.places.push_back(ends[1]);
  }

  // The neighborhoods of all places are whole.
  void paint_uncut() {
    ClassMeshes meshes;
    std::set<std::uint32_t> places;
    const double size = 0.1 * record_.bounds.radius();
    for (std::size_t i = record_.first_step[0]; i < record_.first_step[1]; ++i)
      for (const TracePlace& place : places_of(record_.event(i)))
        if (places.size() < most_fans && places.insert(place.number).second)
          add_fans(record_, place.number, size, meshes);
    paint_classes(meshes, 0.6f, true);
  }

  void paint_null_edges() {
    paint_operands(true);
    if (first_ == last_) return paint_uncut();
    Lines edges = lines(faint(theme_.null_edge), 2);
    Points from = points(faint(theme_.null_edge_above), 5),
           to = points(faint(theme_.null_edge_below), 5);
    for (std::size_t i = first_; i < done(); ++i) add_null_edge(record_.event(i), edges, from, to);
    add(edges);
    add(from);
    add(to);
    if (!current()) return;
    Lines edge = lines(theme_.step, 4);
    Points one = points(theme_.null_edge_above, 9), other = points(theme_.null_edge_below, 9);
    add_null_edge(*current(), edge, one, other);
    add(edge);
    add(one);
    add(other);
  }

  void paint_joining() {
    paint_operands(true);
    if (first_ == last_) return paint_all_contacts();
    Lines joined = lines(theme_.cut, 3), waiting = lines(faint(theme_.contact_segment), 1);
    Points ends = points(theme_.null_edge, 6);
    for (std::size_t i = first_; i < last_; ++i) {
      const TraceEvent& event = record_.event(i);
      add_segment(i < done() ? joined : waiting, event);
      if (i > done() || !current())
        for (const TracePlace& p : places_of(event))
          ends.places.push_back(glm::vec3(to_glm(p.point)));
    }
    add(waiting);
    add(joined);
    add(ends);
    if (current()) highlight(*current());
  }

  void paint_part(const Part& part, double exploded, bool highlighted) {
    if (part.mesh->positions.empty()) return;
    Surface surface;
    surface.mesh = part.mesh;
    surface.colour = part.colour;
    surface.model[3] = glm::dvec4(part.direction * exploded, 1);
    surface.highlighted = highlighted;
    picture_.surfaces.push_back(surface);
    if (!view_.labels) return;
    picture_.labels.push_back({part.mesh->bounds.centre() + part.direction * exploded,
                               part_name(part.solid, part.cls), theme_.text});
  }

  void paint_components() {
    const auto* now = current() ? std::get_if<PartEvent>(current()) : nullptr;
    for (const Part& part : parts_of(record_, theme_, view_.eight_way))
      paint_part(part, view_.exploded,
                 now != nullptr && now->solid == part.solid && now->side == part.lumped);
  }

  // The more wedges are glued, the closer the kept parts are to each other.
  double apart() const {
    if (last_ == first_) return view_.exploded;
    const double left =
        current() ? static_cast<double>(last_ - 1 - current_) / static_cast<double>(last_ - first_)
                  : 1;
    return left * std::max(view_.exploded, 0.3);
  }

  // A wedge's edge where the kept parts of its solids are now.
  static void add_seam(Lines& seams, const TraceEvent& event, const glm::dvec3 (&moved)[2]) {
    for (int s = 0; s < 2; ++s)
      if (!entities_of(event, s).empty())
        for (const TracePlace& p : places_of(event))
          seams.ends.push_back(glm::vec3(to_glm(p.point) + moved[s]));
  }

  void paint_gluing() {
    const double exploded = apart();
    glm::dvec3 moved[2] = {glm::dvec3(0), glm::dvec3(0)};
    for (Part& part : parts_of(record_, theme_, false)) {
      if (part.kept) {
        if (part.turned) part.mesh = turned_inside_out(*part.mesh);
        paint_part(part, exploded, false);
        moved[part.solid] = part.direction * exploded;
      } else if (!part.mesh->positions.empty()) {
        Surface ghost;
        ghost.mesh = part.mesh;
        ghost.colour = with_alpha(part.colour, 0.12f);
        ghost.translucent = true;
        ghost.edges = false;
        picture_.surfaces.push_back(ghost);
      }
    }
    Lines seams = lines(theme_.cut, 3), seam = lines(theme_.step, 5);
    for (std::size_t i = first_; i < done(); ++i) add_seam(seams, record_.event(i), moved);
    add(seams);
    if (current()) add_seam(seam, *current(), moved);
    add(seam);
  }

  void paint_cleanup() {
    Surface surface;
    surface.mesh = record_.result_mesh();
    surface.colour = theme_.result;
    if (!surface.mesh->positions.empty()) picture_.surfaces.push_back(surface);
  }

  static std::string label_of(const TraceEvent& event) {
    const std::string a = names_of(event, 0), b = names_of(event, 1);
    std::string text = a.empty() ? "" : "A " + a;
    if (!b.empty()) text += (text.empty() ? "B " : " · B ") + b;
    return text;
  }

  void add_label(const TraceEvent& event) {
    const std::span<const TracePlace> places = places_of(event);
    if (places.empty()) return;
    glm::dvec3 centre(0);
    for (const TracePlace& p : places) centre += to_glm(p.point);
    picture_.labels.push_back(
        {centre / static_cast<double>(places.size()), label_of(event), theme_.text});
  }

  void paint_labels() {
    if (!view_.labels) return;
    if (done() - first_ <= most_labels)
      for (std::size_t i = first_; i < done(); ++i) add_label(record_.event(i));
    if (current()) add_label(*current());
  }

  const StoryRecord& record_;
  Phase phase_;
  std::size_t first_, last_, current_;
  const StoryView& view_;
  const Theme& theme_;
  Picture picture_;
};

}  // namespace

Picture draw_step(const StoryRecord& record, std::size_t step, const StoryView& view) {
  return Painter(record, record.steps.at(step).phase, step, view).run();
}

Picture draw_phase(const StoryRecord& record, Phase phase, const StoryView& view) {
  return Painter(record, phase, no_step, view).run();
}

Bounds place_of_step(const StoryRecord& record, std::size_t step) {
  const TraceEvent& event = record.events[record.steps.at(step).event];
  const std::span<const TracePlace> places = places_of(event);
  if (places.empty()) return record.bounds;
  Bounds bounds;
  for (const TracePlace& p : places) bounds.add(to_glm(p.point));
  const double room = 2 * neighborhood_size(record, event);
  bounds.add(bounds.low - room);
  bounds.add(bounds.high + room);
  return bounds;
}

}  // namespace sectile::viewer
