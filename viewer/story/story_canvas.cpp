#include "story/story_canvas.h"

#include <algorithm>
#include <span>
#include <utility>

#include "story/split_plane.h"
#include "story/wording.h"

namespace sectile::viewer {

namespace {

constexpr std::size_t most_labels = 60;

}  // namespace

StoryCanvas::StoryCanvas(const StoryRecord& record, Phase phase, std::size_t current,
                         const StoryView& view)
    : record_(record),
      phase_(phase),
      first_(record.first_step[static_cast<std::size_t>(phase)]),
      last_(record.first_step[static_cast<std::size_t>(phase) + 1]),
      current_(current),
      view_(view),
      theme_(theme(view.dark)) {
  picture_.surroundings = theme_.surroundings;
}

Picture StoryCanvas::finished() {
  paint_labels();
  return std::move(picture_);
}

// Steps before the current one.
std::size_t StoryCanvas::done() const {
  return current_ == no_step ? first_ : current_;
}

const TraceEvent* StoryCanvas::current() const {
  return current_ == no_step ? nullptr : &record_.event(current_);
}

void StoryCanvas::explain(const std::string& text, const Colour& colour, Form form) {
  const LegendKey key{text, with_alpha(colour, 1), form};
  const bool known = std::any_of(
      picture_.legend.begin(), picture_.legend.end(),
      [&](const LegendKey& other) { return other.text == key.text && other.colour == key.colour; });
  if (!known) picture_.legend.push_back(key);
}

std::string StoryCanvas::name_of_solid(int solid) const {
  return solid == 0 ? (record_.split ? "S" : "A") : record_.split ? "the plane" : "B";
}

void StoryCanvas::paint_operands(bool as_wires) {
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

void StoryCanvas::add_segment(Lines& lines, const TraceEvent& event) {
  for (const TracePlace& p : places_of(event)) lines.ends.push_back(glm::vec3(to_glm(p.point)));
}

Lines StoryCanvas::lines(Colour colour, float width) const {
  Lines made;
  made.colour = colour;
  made.width = width;
  made.on_top = true;
  return made;
}

Points StoryCanvas::points(Colour colour, float size) const {
  Points made;
  made.colour = colour;
  made.size = size;
  return made;
}

void StoryCanvas::add(Lines made, const char* meaning) {
  if (made.ends.empty()) return;
  explain(meaning, made.colour, Form::line);
  picture_.lines.push_back(std::move(made));
}

void StoryCanvas::add(Points made, const char* meaning) {
  if (made.places.empty()) return;
  explain(meaning, made.colour, Form::point);
  picture_.points.push_back(std::move(made));
}

void StoryCanvas::highlight(const TraceEvent& event, float width) {
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

// What the phases after the first start from, where they find nothing to do.
void StoryCanvas::paint_all_contacts() {
  paint_contacts(record_.first_step[0], record_.first_step[1]);
}

void StoryCanvas::paint_contacts(std::size_t from, std::size_t to) {
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

Colour StoryCanvas::class_colour(int solid, std::optional<TraceClass> cls) const {
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

void StoryCanvas::paint_classes(const ClassMeshes& meshes, float alpha, bool edges) {
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

std::string StoryCanvas::name_of_class(int solid, TraceClass cls) const {
  if (!record_.split) return part_name(solid, cls);
  if (solid == 1)
    return cls == TraceClass::in    ? "the plane in S"
           : cls == TraceClass::out ? "the plane beside S"
                                    : "the plane on S";
  if (is_on(cls)) return "on";
  return (cls == TraceClass::in) == record_.split->above ? "above" : "below";
}

void StoryCanvas::name_place(const glm::dvec3& place, int solid, const std::string& name) {
  const std::string of = record_.split && solid == 1 ? "plane" : name_of_solid(solid) + " " + name;
  picture_.labels.push_back({place, of, with_alpha(solid == 0 ? theme_.a : theme_.b, 1), true});
}

std::string StoryCanvas::label_of(const TraceEvent& event) {
  const std::string a = names_of(event, 0), b = names_of(event, 1);
  std::string text = a.empty() ? "" : "A " + a;
  if (!b.empty()) text += (text.empty() ? "B " : " · B ") + b;
  return text;
}

void StoryCanvas::add_label(const TraceEvent& event) {
  const std::span<const TracePlace> places = places_of(event);
  if (places.empty()) return;
  glm::dvec3 centre(0);
  for (const TracePlace& p : places) centre += to_glm(p.point);
  picture_.labels.push_back(
      {centre / static_cast<double>(places.size()), label_of(event), theme_.text});
}

void StoryCanvas::paint_labels() {
  if (!view_.labels) return;
  if (done() - first_ <= most_labels)
    for (std::size_t i = first_; i < done(); ++i) add_label(record_.event(i));
}

}  // namespace sectile::viewer
