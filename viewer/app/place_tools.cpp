#include "app/place_tools.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

const char* said(bool exact) {
  return exact ? "exact" : "near, not exact (sums of two doubles cannot say it)";
}

/// The corners of a face in the coordinates of its solid.
std::vector<ExactCorner> corners_of(const PickedSpot& spot) {
  // The features know the vertices of the face by their place in the world.
  const SnapFeatures& features = spot.features->features();
  std::vector<ExactCorner> corners;
  const std::vector<Vec3> outline = spot.features->outline(spot.face());
  for (const SnapFeatures::Vertex& vertex : features.vertices)
    if (std::find(outline.begin(), outline.end(), vertex.point) != outline.end())
      corners.push_back(features.corners[vertex.corner]);
  if (corners.empty())
    for (const SnapFeatures::CornerIndex corner : spot.face().corners)
      corners.push_back(features.corners[corner]);
  return corners;
}

/// An edge that begins at the end nearer to where it was picked.
PlacedEdge edge_of(const PickedSpot& spot) {
  const SnapFeatures::Edge& edge = spot.edge();
  const std::vector<ExactCorner>& corners = spot.features->features().corners;
  const glm::dvec3 p = to_glm(spot.point);
  PlacedEdge made{corners[edge.corners[0]], corners[edge.corners[1]], spot.features->place()};
  if (glm::distance(p, to_glm(edge.to)) < glm::distance(p, to_glm(edge.from)))
    std::swap(made.from, made.to);
  return made;
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
    session.interface.messages.tell("There is none under the pointer: click where one lights up.");
    return;
  }
  if (!first_) {
    first_ = spot;
    start_ = standing_of(session.scene(), spot->node, spot->mover);
    return;
  }
  if (session.scene().is_below(spot->node, first_->mover)) {
    session.interface.messages.tell(
        "That belongs to the solid that is to be moved: pick another solid.");
    return;
  }
  second_ = spot;
  show(session);
}

void PlaceTool::show(Session& session) {
  landing_ = land(start_, *first_, *second_);
  Scene scene = session.scene();
  scene.edit(first_->mover).placement = landing_.placement;
  session.document.show_draft(title(), std::move(scene));
  session.interface.dragging = title() + ": " + said(landing_.is_exact);
}

void PlaceTool::take(Session& session) {
  if (!session.document.has_draft()) return show(session);  // another one took its place
  session.document.commit_draft();
  session.interface.dragging.clear();
  session.interface.messages.tell(title() + ": " + said(landing_.is_exact) + ".");
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
  session.interface.dragging.clear();
}

void PlaceTool::scene_changed(Session& session) {
  if (!first_) return;
  give_up(session);
  hovered_.reset(), first_.reset(), second_.reset();
  session.interface.messages.tell("The scene has changed: pick again.");
}

void PlaceTool::preview_undone(Session& session) {
  session.interface.dragging.clear();
  second_.reset();
}

void PlaceTool::add_to(Picture& picture, const ViewState& view) const {
  const Theme& colours = theme(view.dark);
  if (hovered_) add_spot(picture, *hovered_, colours.hover);
  if (first_ && !second_) add_spot(picture, *first_, colours.b);
  if (second_) add_spot(picture, *second_, colours.step);
}

std::string FaceOnFace::hint(const ViewState&) const {
  if (!has_first()) return "Click the face that is to be moved.";
  if (!has_both()) return "Click the face on which it is to lie.";
  return std::string(is_exact() ? "Exact" : "Near, not exact (sums of two doubles cannot say it)") +
         " \u00B7 C: centred (" + (options_.centred ? "on" : "off") +
         ") \u00B7 T: " + (options_.same_side ? "touching" : "level, on the same side") +
         " \u00B7 Enter or click: take \u00B7 Esc: give back";
}

std::optional<PickedSpot> FaceOnFace::pick(const Session& session, glm::dvec2 pixel) {
  return picker_.face_at(session, pixel);
}

Landing FaceOnFace::land(const Standing& start, const PickedSpot& moved,
                         const PickedSpot& fixed) const {
  return flush(start, {moved.face().normal, corners_of(moved)},
               {fixed.face().normal, corners_of(fixed), fixed.features->place()}, options_);
}

bool FaceOnFace::option(char letter) {
  if (letter == 'C') options_.centred = !options_.centred;
  if (letter == 'T') options_.same_side = !options_.same_side;
  return letter == 'C' || letter == 'T';
}

std::string EdgeOnEdge::hint(const ViewState&) const {
  if (!has_first()) return "Click the edge that is to be moved, near the end that matters.";
  if (!has_both()) return "Click the edge on which it is to lie, near the end that it is to meet.";
  return std::string(is_exact() ? "Exact" : "Near, not exact (sums of two doubles cannot say it)") +
         " \u00B7 T: turn it round \u00B7 Enter or click: take \u00B7 Esc: give back";
}

std::optional<PickedSpot> EdgeOnEdge::pick(const Session& session, glm::dvec2 pixel) {
  return picker_.edge_at(session, pixel);
}

Landing EdgeOnEdge::land(const Standing& start, const PickedSpot& moved,
                         const PickedSpot& fixed) const {
  PlacedEdge own = edge_of(moved);
  if (turned_round_) std::swap(own.from, own.to);
  return edge_on_edge(start, own, edge_of(fixed));
}

bool EdgeOnEdge::option(char letter) {
  if (letter == 'T') turned_round_ = !turned_round_;
  return letter == 'T';
}

}  // namespace sectile::viewer
