#include "app/place_tools.h"

#include <cmath>

#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

const char* said(bool exact) {
  return exact ? "exact" : "near, not exact (doubles cannot say it)";
}

/// The corners of a face in the coordinates of its solid.
std::vector<Vec3> local_corners(const PickedSpot& spot) {
  // The features know the vertices of the face by their place in the world.
  std::vector<Vec3> corners;
  const std::vector<Vec3> outline = spot.features->outline(spot.face());
  for (const SnapFeatures::Vertex& vertex : spot.features->features().vertices)
    for (const Vec3& end : outline)
      if (end == vertex.point) {
        corners.push_back(vertex.local);
        break;
      }
  if (corners.empty()) corners.push_back(spot.face().local);
  return corners;
}

std::vector<Vec3> world_corners(const PickedSpot& spot) {
  std::vector<Vec3> corners = spot.features->outline(spot.face());
  if (corners.empty()) corners.push_back(spot.face().point);
  return corners;
}

/// An edge that begins at the end nearer to where it was picked.
PlacedEdge edge_from(const PickedSpot& spot, const Vec3& from, const Vec3& to) {
  const glm::dvec3 p = to_glm(spot.point);
  const bool turn =
      glm::distance(p, to_glm(spot.edge().to)) < glm::distance(p, to_glm(spot.edge().from));
  return turn ? PlacedEdge{to, from} : PlacedEdge{from, to};
}

Vec3 local_of(const PickedSpot& spot, const Vec3& in_world) {
  for (const SnapFeatures::Vertex& vertex : spot.features->features().vertices)
    if (vertex.point == in_world) return vertex.local;
  return spot.edge().local;
}

}  // namespace

void PlaceTool::follow(Session& session, const Pointer& pointer) {
  if (!has_both()) hovered_ = pick(session, pointer.at);
}

void PlaceTool::press(Session& session, const Pointer& pointer) {
  if (has_both()) return take(session);
  const std::optional<PickedSpot> spot = pick(session, pointer.at);
  hovered_.reset();
  if (!spot) {
    session.messages.tell("There is none under the pointer: click where one lights up.");
    return;
  }
  if (!first_) {
    first_ = spot;
    start_ = standing_of(session.scene(), spot->node, spot->mover);
    return;
  }
  if (session.scene().is_below(spot->node, first_->mover)) {
    session.messages.tell("That belongs to the solid that is to be moved: pick another solid.");
    return;
  }
  second_ = spot;
  show(session);
}

void PlaceTool::show(Session& session) {
  landing_ = land(start_, *first_, *second_);
  // What is computed in the coordinates of an operation or group that was moved may round again.
  const Scene& now = session.scene();
  landing_.is_exact = landing_.is_exact && is_identity(start_.parent) &&
                      is_identity(now.world_of_parent(second_->node));
  Scene scene = now;
  scene.edit(first_->mover).placement = landing_.placement;
  session.document.show_draft(title(), std::move(scene));
  session.dragging = title() + ": " + said(landing_.is_exact);
}

void PlaceTool::take(Session& session) {
  session.document.commit_draft();
  session.dragging.clear();
  session.messages.tell(title() + ": " + said(landing_.is_exact) + ".");
  session.select(first_->mover);
  finish();
}

bool PlaceTool::key(Session& session, const Event& event) {
  if (event.key == Key::enter && has_both()) {
    take(session);
    return true;
  }
  if (event.control || !option(static_cast<char>(event.key))) return false;
  if (has_both()) show(session);
  return true;
}

void PlaceTool::give_up(Session& session) {
  session.document.drop_draft();
  session.dragging.clear();
}

void PlaceTool::add_to(Picture& picture, const Session& session) const {
  const Theme& colours = theme(session.view.dark);
  if (hovered_) add_spot(picture, *hovered_, colours.hover);
  if (first_ && !second_) add_spot(picture, *first_, colours.b);
  if (second_) add_spot(picture, *second_, colours.step);
}

std::string FaceOnFace::hint(const Session&) const {
  if (!has_first()) return "Click the face that is to be moved.";
  if (!has_both()) return "Click the face on which it is to lie.";
  return std::string(is_exact() ? "Exact" : "Near, not exact (doubles cannot say it)") +
         " \u00B7 C: centred (" + (options_.centred ? "on" : "off") +
         ") \u00B7 T: " + (options_.same_side ? "touching" : "level, on the same side") +
         " \u00B7 Enter or click: take \u00B7 Esc: give back";
}

std::optional<PickedSpot> FaceOnFace::pick(const Session& session, glm::dvec2 pixel) {
  return picker_.face_at(session, pixel);
}

Landing FaceOnFace::land(const Standing& start, const PickedSpot& moved,
                         const PickedSpot& fixed) const {
  return flush(start, {moved.face().normal, local_corners(moved)},
               {fixed.face().normal, world_corners(fixed)}, options_);
}

bool FaceOnFace::option(char letter) {
  if (letter == 'C') options_.centred = !options_.centred;
  if (letter == 'T') options_.same_side = !options_.same_side;
  return letter == 'C' || letter == 'T';
}

std::string EdgeOnEdge::hint(const Session&) const {
  if (!has_first()) return "Click the edge that is to be moved, near the end that matters.";
  if (!has_both()) return "Click the edge on which it is to lie, near the end that it is to meet.";
  return std::string(is_exact() ? "Exact" : "Near, not exact (doubles cannot say it)") +
         " \u00B7 T: turn it round \u00B7 Enter or click: take \u00B7 Esc: give back";
}

std::optional<PickedSpot> EdgeOnEdge::pick(const Session& session, glm::dvec2 pixel) {
  return picker_.edge_at(session, pixel);
}

Landing EdgeOnEdge::land(const Standing& start, const PickedSpot& moved,
                         const PickedSpot& fixed) const {
  const SnapFeatures::Edge& edge = moved.edge();
  PlacedEdge own = edge_from(moved, local_of(moved, edge.from), local_of(moved, edge.to));
  if (turned_round_) std::swap(own.from, own.to);
  return edge_on_edge(start, own, edge_from(fixed, fixed.edge().from, fixed.edge().to));
}

bool EdgeOnEdge::option(char letter) {
  if (letter == 'T') turned_round_ = !turned_round_;
  return letter == 'T';
}

}  // namespace sectile::viewer
