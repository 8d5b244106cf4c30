#include "story/parts_painter.h"

#include <algorithm>
#include <span>

#include "story/wording.h"

namespace sectile::viewer {

Picture PartsPainter::run() {
  if (phase_ == Phase::components)
    paint_components();
  else if (phase_ == Phase::gluing)
    paint_gluing();
  else
    paint_cleanup();
  return finished();
}

void PartsPainter::paint_part(const Part& part, double exploded, bool highlighted) {
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

std::string PartsPainter::name_of_part(const Part& part) const {
  if (!record_.split) return part_name(part.solid, part.cls);
  if (part.solid == 1) return "the plane in S";
  if (is_on(part.cls)) return "on the plane";
  return (part.cls == TraceClass::in) == record_.split->above ? "Above" : "Below";
}

// The half-space has no far side that anybody would want to see.
bool PartsPainter::is_of_no_interest(const Part& part) const {
  return record_.split && part.solid == 1 && part.cls != TraceClass::in;
}

void PartsPainter::paint_components() {
  const auto* now = current() ? std::get_if<PartEvent>(current()) : nullptr;
  for (const Part& part : parts_of(record_, theme_, view_.eight_way))
    if (!is_of_no_interest(part))
      paint_part(part, view_.exploded,
                 now != nullptr && now->solid == part.solid && now->side == part.lumped);
}

// The more wedges are glued, the closer the kept parts are to each other.
double PartsPainter::apart() const {
  if (last_ == first_) return view_.exploded;
  const double left =
      current() ? static_cast<double>(last_ - 1 - current_) / static_cast<double>(last_ - first_)
                : 1;
  return left * std::max(view_.exploded, 0.3);
}

// A wedge's edge where the kept parts of its solids are now.
void PartsPainter::add_seam(Lines& seams, const TraceEvent& event, const glm::dvec3 (&moved)[2]) {
  for (int s = 0; s < 2; ++s)
    if (!entities_of(event, s).empty())
      for (const TracePlace& p : places_of(event))
        seams.ends.push_back(glm::vec3(to_glm(p.point) + moved[s]));
}

void PartsPainter::paint_gluing() {
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

void PartsPainter::paint_cleanup() {
  Surface surface;
  surface.mesh = record_.result_mesh();
  surface.colour = theme_.result;
  if (surface.mesh->positions.empty()) return;
  picture_.surfaces.push_back(surface);
  explain("result", surface.colour, Form::area);
}

}  // namespace sectile::viewer
