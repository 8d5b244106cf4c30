#include "story/neighborhood_mesh.h"

#include <cmath>
#include <numbers>

#include "story/sphere_picture.h"

namespace sectile::viewer {
namespace {

SurfaceMesh& mesh_for(ClassMeshes& meshes, int solid, std::optional<TraceClass> cls) {
  auto& mesh = meshes[{solid, cls}];
  if (!mesh) mesh = std::make_shared<SurfaceMesh>();
  return *mesh;
}

void add_triangle(SurfaceMesh& mesh, const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r,
                  const glm::dvec3& normal) {
  for (const glm::dvec3& corner : {p, q, r}) {
    mesh.positions.push_back(glm::vec3(corner));
    mesh.normals.push_back(glm::vec3(normal));
    mesh.bounds.add(corner);
  }
  mesh.faces.push_back(0);
}

void add_edge(SurfaceMesh& mesh, const glm::dvec3& p, const glm::dvec3& q) {
  mesh.hard_edges.push_back(glm::vec3(p));
  mesh.hard_edges.push_back(glm::vec3(q));
}

double arc_angle(const SpherePicture::Arc& arc) {
  const glm::dvec3 from(arc.from), to(arc.to), normal(arc.normal);
  const double turn = std::atan2(glm::dot(glm::cross(from, to), normal), glm::dot(from, to));
  return turn < 1e-6 ? turn + 2 * std::numbers::pi : turn;
}

// B's sectors are drawn a little deeper in B, so that both of two that coincide can be seen.
glm::dvec3 shifted(const glm::dvec3& centre, int solid, const glm::dvec3& normal, double size) {
  return solid == 1 ? centre - normal * (0.01 * size) : centre;
}

void add_fan(SurfaceMesh& mesh, const SpherePicture::Arc& arc, const glm::dvec3& centre,
             double radius) {
  const glm::dvec3 from(arc.from), normal(arc.normal);
  const glm::dvec3 aside = glm::cross(normal, from);
  const double angle = arc_angle(arc);
  const int pieces = std::max(1, static_cast<int>(std::ceil(angle / 0.15)));
  const auto rim = [&](int i) {
    const double t = angle * i / pieces;
    return centre + (from * std::cos(t) + aside * std::sin(t)) * radius;
  };
  for (int i = 0; i < pieces; ++i) {
    add_triangle(mesh, centre, rim(i), rim(i + 1), normal);
    add_edge(mesh, rim(i), rim(i + 1));
  }
  add_edge(mesh, centre, rim(0));
  add_edge(mesh, centre, rim(pieces));
}

}  // namespace

glm::dvec3 middle_of(const SpherePicture::Arc& arc) {
  const glm::dvec3 from(arc.from), aside = glm::cross(glm::dvec3(arc.normal), from);
  const double t = 0.5 * arc_angle(arc);
  return from * std::cos(t) + aside * std::sin(t);
}

void add_fan(ClassMeshes& meshes, const SpherePicture::Arc& arc, const glm::dvec3& centre,
             double radius) {
  add_fan(mesh_for(meshes, arc.solid, arc.cls), arc,
          shifted(centre, arc.solid, glm::dvec3(arc.normal), radius), radius);
}

void add_fans(const StoryRecord& record, std::uint32_t place, double radius, ClassMeshes& meshes,
              const std::optional<glm::dvec3>& drawn_at) {
  const auto contacts = record.contacts.at(place);
  if (contacts.empty()) return;
  const glm::dvec3 centre =
      drawn_at.value_or(to_glm(places_of(record.events[contacts[0]])[0].point));
  for (const SpherePicture::Arc& arc : sphere_at(record, place).arcs)
    add_fan(meshes, arc, centre, arc.solid == 0 ? radius : 0.85 * radius);
}

void add_strip(ClassMeshes& meshes, const TraceHalfPlane& h, const std::array<TracePlace, 2>& ends,
               double width, double margin) {
  const glm::dvec3 p = to_glm(ends[0].point), q = to_glm(ends[1].point);
  const double length = glm::length(q - p);
  if (length <= 2 * margin) return;
  const glm::dvec3 inwards = (q - p) * (margin / length), normal = to_glm(h.normal);
  const double size = h.solid == 0 ? width : 0.85 * width;
  const glm::dvec3 start = shifted(p + inwards, h.solid, normal, width),
                   end = shifted(q - inwards, h.solid, normal, width),
                   out = to_glm(h.direction) * size;
  SurfaceMesh& mesh = mesh_for(meshes, h.solid, h.before);
  add_triangle(mesh, start, end, end + out, normal);
  add_triangle(mesh, start, end + out, start + out, normal);
  add_edge(mesh, start + out, end + out);
}

void add_strips(const NeighborhoodEvent& neighborhood, double width, double margin,
                ClassMeshes& meshes) {
  for (const TraceHalfPlane& h : neighborhood.half_planes)
    add_strip(meshes, h, neighborhood.ends, width, margin);
}

}  // namespace sectile::viewer
