// Moving a solid. If every explicit point has an exact image, the solid is mapped as it is, with
// all its implicit points; otherwise its faces, with rounded corners, make a new one.
#include <algorithm>
#include <cmath>
#include <utility>

#include "import/soup.h"
#include "primitives/arguments.h"
#include "primitives/exact_affine.h"
#include "sectile/transform.h"

namespace sectile {

namespace {

bool map_points(const Geometry& from, const ExactAffine& affine, Geometry& to) {
  for (std::size_t p = 0; p < from.positions.size(); ++p)
    if (from.is_explicit(PointId(p)) && !affine.map(from.positions[p], to.positions[p]))
      return false;
  return true;
}

bool map_plane(const PlaneDefinition& from, const ExactAffine& affine, PlaneDefinition& to) {
  const bool mirrored = affine.mirrors();
  if (from.kind() == PlaneDefinition::Kind::three_points) {
    if (mirrored) std::swap(to.b, to.c);
    return true;
  }
  if (from.kind() == PlaneDefinition::Kind::coefficients) return true;
  bool reversed = false;
  const int image = affine.axis_image(axis_of(from.kind()), reversed);
  if (image < 0) return false;
  PointId a(from.a), b(from.b);
  if (reversed != mirrored) std::swap(a, b);
  to = PlaneDefinition::along_axis(a, b, image);
  return true;
}

bool map_planes(const Geometry& from, const ExactAffine& affine, Geometry& to) {
  for (std::size_t s = 0; s < from.planes.size(); ++s)
    if (!map_plane(from.planes[s], affine, to.planes[s])) return false;
  for (std::size_t s = 0; s < from.coefficients.size(); ++s)
    if (!affine.map(from.coefficients[s], to.coefficients[s])) return false;
  return true;
}

bool round_implicit_points(Geometry& geometry) {
  const Kernel kernel(geometry);
  for (std::size_t p = 0; p < geometry.positions.size(); ++p) {
    if (geometry.is_explicit(PointId(p))) continue;
    Vec3& position = geometry.positions[p];
    position = kernel.construct(geometry.construction(PointId(p))).position;
    if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
      return false;
  }
  return true;
}

/// Every half-edge runs the other way, so that each face is seen from its other side.
void reverse_faces(Brep& brep) {
  for (std::size_t h = 0; h < brep.half_edge_count(); h += 2)
    std::swap(brep.origin[h], brep.origin[h + 1]);
  std::swap(brep.next, brep.prev);
  for (HalfEdgeId& h : brep.vertex_half_edge)
    if (h.valid()) h = Brep::twin(h);
}

/// The image with nothing rounded, or nothing.
std::shared_ptr<const SolidData> exact_image(const SolidData& data, const ExactAffine& affine) {
  auto image = std::make_shared<SolidData>();
  image->geometry() = data.geometry();
  if (!map_points(data.geometry(), affine, image->geometry())) return nullptr;
  if (!map_planes(data.geometry(), affine, image->geometry())) return nullptr;
  if (!data.geometry().constructions.empty() && !round_implicit_points(image->geometry()))
    return nullptr;
  image->brep() = data.brep();
  image->origin = data.origin;
  if (affine.mirrors()) reverse_faces(image->brep());
  image->cut();
  return image;
}

void add_loop(const Brep& brep, LoopId loop, bool reversed, Soup& soup) {
  const std::size_t first = soup.indices.size();
  for_each_in_loop(brep, loop, [&](HalfEdgeId h) { soup.indices.push_back(brep.from(h).value()); });
  if (reversed)
    std::reverse(soup.indices.begin() + static_cast<std::ptrdiff_t>(first), soup.indices.end());
  soup.loop_sizes.push_back(static_cast<std::uint32_t>(soup.indices.size() - first));
  ++soup.face_loops.back();
}

std::vector<Vec3> rounded_positions(const SolidData& data, const ExactAffine& affine) {
  const Kernel kernel(data.geometry());
  std::vector<Vec3> positions;
  positions.reserve(data.brep().vertex_count());
  for (const PointId p : data.brep().point) {
    const Vec3 image = data.geometry().is_explicit(p) ? affine.rounded(data.geometry().position(p))
                                                      : affine.rounded(kernel.exact(p));
    require(std::isfinite(image.x) && std::isfinite(image.y) && std::isfinite(image.z),
            "The transformed solid would be too large for double coordinates.");
    positions.push_back(image);
  }
  return positions;
}

Soup rounded_faces(const SolidData& data, const ExactAffine& affine) {
  Soup soup;
  soup.positions = rounded_positions(data, affine);
  const bool mirrored = affine.mirrors();
  for (const LoopId outer : data.brep().outer_loop) {
    soup.face_loops.push_back(0);
    for (LoopId l = outer; l.valid(); l = data.brep().next_loop[l.value()])
      add_loop(data.brep(), l, mirrored, soup);
  }
  return soup;
}

std::shared_ptr<const SolidData> rounded_image(const SolidData& data, const ExactAffine& affine) {
  const std::shared_ptr<const SolidData> imported = import_soup(rounded_faces(data, affine));
  auto image = std::make_shared<SolidData>();
  image->brep() = imported->brep();
  image->geometry() = imported->geometry();
  image->origin = data.origin;
  for (FaceSource& source : image->brep().source) source = data.brep().source[source.face];
  image->cut();
  return image;
}

}  // namespace

Solid transformed(const Solid& solid, const Transform& transform) {
  const ExactAffine affine(transform);
  if (solid.is_empty()) return solid;
  std::shared_ptr<const SolidData> image = exact_image(*solid.data(), affine);
  return Solid(image ? image : rounded_image(*solid.data(), affine));
}

}  // namespace sectile
