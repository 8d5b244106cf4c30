#include "app/feature_picking.h"

#include <algorithm>
#include <limits>

#include "app/picture_maker.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr double reach = 9;  // on the screen

std::vector<PickTarget> targets_of(const Session& session) {
  std::vector<PickTarget> targets;
  for (const Shape& shape : visible_shapes(session))
    if (!shape.is_operand) targets.push_back({shape.node, shape.surface.mesh, shape.surface.model});
  return targets;
}

NodeId mover_of(const Document& document, NodeId node) {
  const Selection& chosen = document.selection();
  NodeId top = node;
  for (const Node* n = document.scene().find(node); n; n = document.scene().find(n->parent)) {
    if (std::count(chosen.begin(), chosen.end(), n->id) > 0) return n->id;
    top = n->id;
  }
  return top;
}

double distance_to_box(const glm::dvec3& p, const Vec3& low, const Vec3& high) {
  return glm::distance(p, glm::clamp(p, to_glm(low), to_glm(high)));
}

/// The face of the solid that a hit lies in: its plane is the nearest, its box the smallest.
std::optional<std::size_t> face_at_point(const SnapFeatures& features, const glm::dvec3& point,
                                         const glm::dvec3& normal) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < features.faces.size(); ++i) {
    const SnapFeatures::Face& face = features.faces[i];
    if (glm::dot(to_glm(face.normal), normal) < 0.99) continue;
    const double size = glm::distance(to_glm(face.low), to_glm(face.high));
    const double off = std::abs(glm::dot(point - to_glm(face.point), to_glm(face.normal))) +
                       distance_to_box(point, face.low, face.high);
    const double badness = 1e4 * off + size;
    if (badness < least) least = badness, best = i;
  }
  return best;
}

double distance_to_segment(const glm::dvec3& p, const SnapFeatures::Edge& edge) {
  const glm::dvec3 a = to_glm(edge.from), d = to_glm(edge.to) - a;
  const double length = glm::dot(d, d);
  const double t = length > 0 ? glm::clamp(glm::dot(p - a, d) / length, 0.0, 1.0) : 0;
  return glm::distance(p, a + t * d);
}

std::optional<std::size_t> edge_at_point(const SnapFeatures& features, const glm::dvec3& point,
                                         const glm::dvec3& direction) {
  std::optional<std::size_t> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < features.edges.size(); ++i) {
    const SnapFeatures::Edge& edge = features.edges[i];
    const glm::dvec3 d = to_glm(edge.to) - to_glm(edge.from);
    if (std::abs(glm::dot(d, direction)) < 0.99 * glm::length(d) * glm::length(direction)) continue;
    const double off = distance_to_segment(point, edge);
    if (off < least) least = off, best = i;
  }
  return best;
}

ExactTransform way_up(const Scene& scene, NodeId id, NodeId top) {
  if (id == top) return {};
  return way_up(scene, scene.at(id).parent, top) * scene.at(id).placement.exact();
}

void add_box(const Scene& scene, const Results& results, NodeId id, NodeId mover, ExactBox& box) {
  if (const Solid* inside = results.inside(id))
    return box.add(standing_of(scene, id, mover), exact_mesh(*inside).corners);
  for (const NodeId child : scene.at(id).children) add_box(scene, results, child, mover, box);
}

}  // namespace

std::vector<Vec3> PickedSpot::shown() const {
  if (kind == PickedFeature::Kind::face) return features->outline(face());
  if (kind == PickedFeature::Kind::edge) return {edge().from, edge().to};
  return {};
}

std::optional<PickedSpot> FeaturePicker::spot_of(const Document& document, const Results& results,
                                                 NodeId node) {
  const Solid* inside = results.inside(node);
  if (!inside) return std::nullopt;
  PickedSpot spot;
  spot.node = node;
  spot.mover = mover_of(document, node);
  spot.features = known_.of(*inside, document.scene().exact_world(node));
  return spot;
}

std::optional<PickedSpot> FeaturePicker::face_at(const Session& session, glm::dvec2 pixel) {
  const Ray ray = session.view.camera.ray(pixel, session.view.picture_size);
  const SectionPlane section{session.view.section, session.view.section_plane()};
  const std::optional<Hit> hit = picker_.pick(ray, targets_of(session), section);
  std::optional<PickedSpot> spot =
      hit ? spot_of(session.document, session.results, hit->node) : std::nullopt;
  if (!spot) return std::nullopt;
  const auto face = face_at_point(spot->features->features(), hit->point, hit->normal);
  if (!face) return std::nullopt;
  spot->kind = PickedFeature::Kind::face;
  spot->index = *face;
  spot->point = from_glm(hit->point);
  return spot;
}

std::optional<PickedSpot> FeaturePicker::any_at(const Session& session, glm::dvec2 pixel) {
  const std::optional<PickedFeature> found = picker_.pick_feature(
      session.view.camera, pixel, session.view.picture_size, reach, targets_of(session));
  if (!found || found->kind == PickedFeature::Kind::face) return face_at(session, pixel);
  std::optional<PickedSpot> spot = spot_of(session.document, session.results, found->node);
  if (!spot) return std::nullopt;
  const SnapFeatures& features = spot->features->features();
  spot->kind = found->kind;
  spot->point = from_glm(found->point);
  if (found->kind == PickedFeature::Kind::edge) {
    const auto edge = edge_at_point(features, found->point, found->ends[1] - found->ends[0]);
    if (!edge) return std::nullopt;
    spot->index = *edge;
    return spot;
  }
  double least = std::numeric_limits<double>::infinity();
  for (const SnapFeatures::Vertex& vertex : features.vertices) {
    const double off = glm::distance(to_glm(vertex.point), found->point);
    if (off < least) least = off, spot->point = vertex.point;
  }
  return spot;
}

std::optional<PickedSpot> FeaturePicker::edge_at(const Session& session, glm::dvec2 pixel) {
  std::optional<PickedSpot> spot = any_at(session, pixel);
  if (spot && spot->kind == PickedFeature::Kind::vertex) {
    // At a corner the edge that leads towards the pointer is meant.
    const glm::dvec3 corner = to_glm(spot->point);
    const glm::dvec2 seen(session.view.camera.project(corner, session.view.picture_size));
    double best = -2;
    const auto& edges = spot->features->features().edges;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      if (edges[i].from != spot->point && edges[i].to != spot->point) continue;
      const Vec3 end = edges[i].from == spot->point ? edges[i].to : edges[i].from;
      const glm::dvec2 way =
          glm::dvec2(session.view.camera.project(to_glm(end), session.view.picture_size)) - seen;
      const double along =
          glm::length(way) > 0 ? glm::dot(way, pixel - seen) / glm::length(way) : -1;
      if (along > best || best == -2) best = along, spot->index = i;
    }
    if (best == -2) return std::nullopt;
    spot->kind = PickedFeature::Kind::edge;
  }
  return spot && spot->kind == PickedFeature::Kind::edge ? spot : std::nullopt;
}

Standing standing_of(const Scene& scene, NodeId node, NodeId mover) {
  return {scene.at(mover).placement, scene.exact_world_of_parent(mover),
          way_up(scene, node, mover)};
}

ExactBox exact_box_of(const Scene& scene, const Results& results, NodeId id) {
  ExactBox box;
  add_box(scene, results, id, id, box);
  return box;
}

void add_spot(Picture& picture, const PickedSpot& spot, const Colour& colour) {
  std::vector<glm::vec3> ends;
  for (const Vec3& p : spot.shown()) ends.emplace_back(to_glm(p));
  if (!ends.empty()) picture.lines.push_back({std::move(ends), colour, 4, true});
  if (spot.kind == PickedFeature::Kind::vertex)
    picture.points.push_back({{glm::vec3(to_glm(spot.point))}, colour, 12});
}

}  // namespace sectile::viewer
