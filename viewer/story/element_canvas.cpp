#include "story/element_canvas.h"

#include <optional>
#include <span>

#include "story/row_elements.h"
#include "story/wording.h"

namespace sectile::viewer {

// Lights what the texts name at a place, each with its name at its end.
void ElementCanvas::light_names(const TraceEvent& event, std::uint32_t place, double size) {
  const auto contacts = record_.contacts.at(place);
  if (contacts.empty()) return;
  const glm::dvec3 centre = shown_place(event, place);
  const SpherePicture sphere = sphere_at(record_, place);
  for (int s = 0; s < 2; ++s)
    for (const TraceEntity& entity : entities_of(event, s))
      light_name(s, name_of(entity), centre, sphere, size);
}

glm::dvec3 ElementCanvas::shown_place(const TraceEvent& event, std::uint32_t place) const {
  const std::span<const TracePlace> places = places_of(event);
  const std::size_t i = places.size() > 1 && places[1].number == place ? 1 : 0;
  return to_glm(places[i].point);
}

void ElementCanvas::light_name(int solid, const std::string& name, const glm::dvec3& centre,
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

// The sector or half-plane of the row that is pointed at.
void ElementCanvas::light_row(const TraceEvent& event, double size) {
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

void ElementCanvas::name_middle(const TraceEvent& event) {
  const std::span<const TracePlace> places = places_of(event);
  const glm::dvec3 middle = 0.5 * (to_glm(places[0].point) + to_glm(places[1].point));
  for (int s = 0; s < 2; ++s)
    for (const TraceEntity& entity : entities_of(event, s)) name_place(middle, s, name_of(entity));
}

}  // namespace sectile::viewer
