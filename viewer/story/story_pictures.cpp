#include "story/story_pictures.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>
#include <span>

#include "picture/theme.h"
#include "story/enlarged.h"
#include "story/exploded_parts.h"
#include "story/neighborhood_mesh.h"
#include "story/row_elements.h"
#include "story/sphere_picture.h"
#include "story/split_plane.h"
#include "story/wording.h"

namespace sectile::viewer {
namespace {

constexpr std::size_t no_step = std::numeric_limits<std::size_t>::max();
constexpr std::size_t most_labels = 60;
// So many places show their sectors at once; more would hide each other.
constexpr std::size_t most_fans = 48;

using Form = LegendKey::Form;

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

  void explain(const std::string& text, const Colour& colour, Form form) {
    const LegendKey key{text, with_alpha(colour, 1), form};
    const bool known =
        std::any_of(picture_.legend.begin(), picture_.legend.end(), [&](const LegendKey& other) {
          return other.text == key.text && other.colour == key.colour;
        });
    if (!known) picture_.legend.push_back(key);
  }
  std::string name_of_solid(int solid) const {
    return solid == 0 ? (record_.split ? "S" : "A") : record_.split ? "the plane" : "B";
  }

  void paint_operands(bool as_wires) {
    for (int s = 0; s < 2; ++s) {
      explain(name_of_solid(s), s == 0 ? theme_.a : theme_.b, as_wires ? Form::line : Form::area);
      if (s == 1 && record_.split) {
        picture_.surfaces.push_back(plane_of_split(record_, theme_.b));
        continue;
      }
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
  void add(Lines made, const char* meaning) {
    if (made.ends.empty()) return;
    explain(meaning, made.colour, Form::line);
    picture_.lines.push_back(std::move(made));
  }
  void add(Points made, const char* meaning) {
    if (made.places.empty()) return;
    explain(meaning, made.colour, Form::point);
    picture_.points.push_back(std::move(made));
  }

  void highlight(const TraceEvent& event, float width = 5) {
    const std::span<const TracePlace> places = places_of(event);
    if (places.size() == 2) {
      Lines made = lines(theme_.step, width);
      add_segment(made, event);
      add(made, "this step");
    }
    Points ends = points(theme_.step, places.size() == 1 ? 13.0f : 8.0f);
    for (const TracePlace& p : places) ends.places.push_back(glm::vec3(to_glm(p.point)));
    add(ends, "this step");
  }

  void paint_reduction() {
    paint_operands(false);
    paint_contacts(first_, done());
    if (!current()) return;
    const TraceEvent shown = enlarged(record_, *current());
    highlight(shown);
    light_names(shown, record_.main_place(shown), neighborhood_size(record_, shown));
  }

  // What the phases after the first start from, where they find nothing to do.
  void paint_all_contacts() { paint_contacts(record_.first_step[0], record_.first_step[1]); }

  void paint_contacts(std::size_t from, std::size_t to) {
    // Vertices that coincide; vertices in faces; edges through faces.
    Points coincident = points(theme_.coincident, 9), in_face = points(theme_.contact, 8),
           through = points(theme_.contact, 6);
    Lines across = lines(theme_.contact_segment, 1.5f), along = lines(theme_.coincident, 2.5f);
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
    add(across, "faces cross");
    add(along, "along an edge");
    add(through, "other contacts");
    add(in_face, "other contacts");
    add(coincident, "vertices in one place");
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
      explain(key.second ? name_of_class(key.first, *key.second) : "not yet known", surface.colour,
              Form::area);
    }
  }

  std::string name_of_class(int solid, TraceClass cls) const {
    if (!record_.split) return part_name(solid, cls);
    if (solid == 1)
      return cls == TraceClass::in    ? "the plane in S"
             : cls == TraceClass::out ? "the plane beside S"
                                      : "the plane on S";
    if (is_on(cls)) return "on";
    return (cls == TraceClass::in) == record_.split->above ? "above" : "below";
  }

  // Lights what the texts name at a place, each with its name at its end.
  void light_names(const TraceEvent& event, std::uint32_t place, double size) {
    const auto contacts = record_.contacts.at(place);
    if (contacts.empty()) return;
    const glm::dvec3 centre = shown_place(event, place);
    const SpherePicture sphere = sphere_at(record_, place);
    for (int s = 0; s < 2; ++s)
      for (const TraceEntity& entity : entities_of(event, s))
        light_name(s, name_of(entity), centre, sphere, size);
  }

  glm::dvec3 shown_place(const TraceEvent& event, std::uint32_t place) const {
    const std::span<const TracePlace> places = places_of(event);
    const std::size_t i = places.size() > 1 && places[1].number == place ? 1 : 0;
    return to_glm(places[i].point);
  }

  void light_name(int solid, const std::string& name, const glm::dvec3& centre,
                  const SpherePicture& sphere, double size) {
    const std::string label = (solid == 0 ? "A " : "B ") + name;
    const Colour colour = with_alpha(solid == 0 ? theme_.a : theme_.b, 1);
    std::optional<glm::dvec3> end;
    Lines rays = lines(colour, 4);
    for (const SpherePicture::Mark& mark : sphere.marks) {
      if (mark.label != label) continue;
      end = centre + glm::dvec3(mark.direction) * size;
      rays.ends.insert(rays.ends.end(), {glm::vec3(centre), glm::vec3(*end)});
    }
    if (!rays.ends.empty()) picture_.lines.push_back(std::move(rays));
    ClassMeshes fan;
    for (const SpherePicture::Arc& arc : sphere.arcs)
      if (arc.label == label && name[0] == 'f') {
        add_fan(fan, arc, centre, size);
        if (!end) end = centre + middle_of(arc) * (0.7 * size);
      }
    if (phase_ == Phase::reduction)
      for (const auto& [key, mesh] : fan) {
        Surface surface;
        surface.mesh = mesh;
        surface.colour = with_alpha(colour, 0.55f);
        surface.translucent = true;
        picture_.surfaces.push_back(surface);
      }
    name_place(end.value_or(centre), solid, name);
  }

  void name_place(const glm::dvec3& place, int solid, const std::string& name) {
    const std::string of =
        record_.split && solid == 1 ? "plane" : name_of_solid(solid) + " " + name;
    picture_.labels.push_back({place, of, with_alpha(solid == 0 ? theme_.a : theme_.b, 1), true});
  }

  // The sector or half-plane of the row that is pointed at.
  void light_row(const TraceEvent& event, double size) {
    if (view_.lit_row < 0 || current_ == no_step) return;
    const std::optional<RowElement> element =
        element_of_row(record_, current_, static_cast<std::size_t>(view_.lit_row));
    if (!element) return;
    ClassMeshes meshes;
    const std::span<const TracePlace> places = places_of(event);
    glm::dvec3 label = to_glm(places[0].point);
    if (element->half_plane) {
      add_strip(meshes, *element->half_plane, {places[0], places[1]}, 1.1 * size, 0);
      label = 0.5 * (to_glm(places[0].point) + to_glm(places[1].point)) +
              to_glm(element->half_plane->direction) * size;
    } else {
      for (const SpherePicture::Arc& arc : sphere_at(record_, record_.main_place(event)).arcs)
        if (arc.label == element->name) {
          add_fan(meshes, arc, label, 1.25 * size);
          label += middle_of(arc) * size;
        }
    }
    for (const auto& [key, mesh] : meshes) {
      Surface surface;
      surface.mesh = mesh;
      surface.colour = theme_.step;
      picture_.surfaces.push_back(surface);
    }
    explain("this row", theme_.step, Form::area);
    const std::string of_class =
        element->cls ? ": " + std::string(name_of(*element->cls)) : std::string();
    picture_.labels.push_back({label, element->name + of_class, theme_.text, true});
  }

  void paint_neighborhoods() {
    paint_operands(true);
    if (!current()) return paint_all_contacts();
    const TraceEvent event = enlarged(record_, *current());
    const std::uint32_t here = record_.main_place(event);
    Lines before = lines(theme_.contact_segment, 1.5f);
    std::set<std::uint32_t> places{here};
    ClassMeshes earlier;
    for (std::size_t i = done(); i-- > first_;) {
      const TraceEvent& other = record_.event(i);
      add_segment(before, other);
      const std::uint32_t place = record_.main_place(other);
      if (places.size() < most_fans && places.insert(place).second)
        add_fans(record_, place, 0.8 * neighborhood_size(record_, other), earlier);
    }
    add(before, "done before");
    const double size = neighborhood_size(record_, event);
    ClassMeshes meshes;
    add_fans(record_, here, size, meshes, shown_place(event, here));
    add_strips(std::get<NeighborhoodEvent>(event), 0.5 * size, 1.15 * size, meshes);
    paint_classes(earlier, 0.4f, false);
    paint_classes(meshes, 0.75f, true);
    highlight(event, 3);
    light_names(event, here, size);
    light_row(event, size);
    const std::string note = note_on_enlargement(record_, *current());
    if (!note.empty())
      picture_.labels.push_back({to_glm(places_of(event)[1].point), note, theme_.text, true});
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
    Lines edges = lines(theme_.null_edge, 2);
    Points from = points(theme_.null_edge_above, 6), to = points(theme_.null_edge_below, 6);
    for (std::size_t i = first_; i < done(); ++i) add_null_edge(record_.event(i), edges, from, to);
    add(edges, "null edge");
    add(from, "its end above");
    add(to, "its end below");
    if (!current()) return;
    Lines edge = lines(theme_.step, 4);
    Points one = points(theme_.null_edge_above, 9), other = points(theme_.null_edge_below, 9);
    add_null_edge(*current(), edge, one, other);
    const glm::vec3 ends[2] = {one.places.back(), other.places.back()};
    add(edge, "this step");
    add(one, "its end above");
    add(other, "its end below");
    const auto& event = std::get<NullEdgeEvent>(*current());
    name_place(glm::dvec3(0.5f * (ends[0] + ends[1])), event.solid, name_of(event.edge));
    name_place(glm::dvec3(ends[0]), event.solid, name_of(event.from));
    name_place(glm::dvec3(ends[1]), event.solid, name_of(event.to));
  }

  void paint_joining() {
    paint_operands(true);
    if (first_ == last_) return paint_all_contacts();
    Lines joined = lines(theme_.cut, 3), waiting = lines(theme_.contact_segment, 1);
    Points ends = points(theme_.null_edge, 6);
    for (std::size_t i = first_; i < last_; ++i) {
      const TraceEvent& event = record_.event(i);
      add_segment(i < done() ? joined : waiting, event);
      if (i > done() || !current())
        for (const TracePlace& p : places_of(event))
          ends.places.push_back(glm::vec3(to_glm(p.point)));
    }
    add(waiting, "to be cut");
    add(joined, "cut");
    add(ends, "null edges to be joined");
    if (!current()) return;
    const TraceEvent shown = enlarged(record_, *current());
    highlight(shown);
    name_middle(shown);
    light_row(shown, neighborhood_size(record_, shown));
  }

  void paint_part(const Part& part, double exploded, bool highlighted) {
    if (part.mesh->positions.empty()) return;
    Surface surface;
    surface.mesh = part.mesh;
    surface.colour = part.colour;
    surface.model[3] = glm::dvec4(part.direction * exploded, 1);
    surface.highlighted = highlighted;
    picture_.surfaces.push_back(surface);
    const std::string name = name_of_part(part);
    explain(name, part.colour, Form::area);
    if (!view_.labels && !highlighted) return;
    picture_.labels.push_back(
        {part.mesh->bounds.centre() + part.direction * exploded, name, theme_.text, highlighted});
  }

  std::string name_of_part(const Part& part) const {
    if (!record_.split) return part_name(part.solid, part.cls);
    if (part.solid == 1) return "the plane in S";
    if (is_on(part.cls)) return "on the plane";
    return (part.cls == TraceClass::in) == record_.split->above ? "Above" : "Below";
  }

  // The half-space has no far side that anybody would want to see.
  bool is_of_no_interest(const Part& part) const {
    return record_.split && part.solid == 1 && part.cls != TraceClass::in;
  }

  void name_middle(const TraceEvent& event) {
    const std::span<const TracePlace> places = places_of(event);
    const glm::dvec3 middle = 0.5 * (to_glm(places[0].point) + to_glm(places[1].point));
    for (int s = 0; s < 2; ++s)
      for (const TraceEntity& entity : entities_of(event, s))
        name_place(middle, s, name_of(entity));
  }

  void paint_components() {
    const auto* now = current() ? std::get_if<PartEvent>(current()) : nullptr;
    for (const Part& part : parts_of(record_, theme_, view_.eight_way))
      if (!is_of_no_interest(part))
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
      } else if (!part.mesh->positions.empty() && !is_of_no_interest(part)) {
        Surface ghost;
        ghost.mesh = part.mesh;
        ghost.colour = with_alpha(part.colour, 0.12f);
        ghost.translucent = true;
        ghost.edges = false;
        picture_.surfaces.push_back(ghost);
        explain(name_of_part(part) + ", dropped", part.colour, Form::area);
      }
    }
    Lines seams = lines(theme_.cut, 3), seam = lines(theme_.step, 5);
    for (std::size_t i = first_; i < done(); ++i) add_seam(seams, record_.event(i), moved);
    for (Lines* some : {&seams, &seam}) some->on_top = false;
    add(seams, "glued");
    if (current()) add_seam(seam, *current(), moved);
    add(seam, "this step");
  }

  void paint_cleanup() {
    Surface surface;
    surface.mesh = record_.result_mesh();
    surface.colour = theme_.result;
    if (surface.mesh->positions.empty()) return;
    picture_.surfaces.push_back(surface);
    explain("result", surface.colour, Form::area);
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
  const TraceEvent event = enlarged(record, record.events[record.steps.at(step).event]);
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
