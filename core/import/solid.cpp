#include "sectile/solid.h"

#include "import/measure.h"
#include "storage/element_counts.h"
#include "storage/faces_as_read.h"
#include "storage/moved_solid.h"
#include "storage/solid_data.h"

namespace sectile {

Solid::Solid() = default;
Solid::~Solid() = default;
Solid::Solid(const Solid&) = default;
Solid::Solid(Solid&&) noexcept = default;
Solid& Solid::operator=(const Solid&) = default;
Solid& Solid::operator=(Solid&&) noexcept = default;
Solid::Solid(std::shared_ptr<const SolidData> data) : data_(std::move(data)) {}
Solid::Solid(std::shared_ptr<const MovedSolid> moved)
    : data_(moved->original()), moved_(std::move(moved)) {}

const std::shared_ptr<const SolidData>& Solid::data() const {
  return moved_ ? moved_->image() : data_;
}

Solid Solid::from_mesh(const PolygonMesh& mesh) {
  return from_mesh(mesh, {});
}

bool Solid::is_empty() const {
  return !data_ || data_->empty();
}

std::uint32_t Solid::origin() const {
  return data_ ? data_->origin : 0;
}

double Solid::volume() const {
  return is_empty() ? 0 : volume_of(*data());
}

double Solid::area() const {
  return is_empty() ? 0 : area_of(*data());
}

SolidCounts Solid::counts() const {
  SolidCounts counts;
  if (is_empty()) return counts;
  const ElementCounts elements = element_counts(*data_);
  counts.vertices = elements.vertices;
  counts.edges = elements.edges;
  counts.faces = elements.faces;
  counts.loops = elements.loops;
  counts.shells = shell_count(*data_);
  // Euler and Poincaré: V - E + F - (L - F) = 2 (S - G).
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  const std::int64_t euler =
      count(counts.vertices) - count(counts.edges) + 2 * count(counts.faces) - count(counts.loops);
  counts.genus = count(counts.shells) - euler / 2;
  return counts;
}

std::vector<std::uint32_t> Solid::joined_faces(std::uint32_t face) const {
  std::vector<std::uint32_t> faces;
  if (data_ && data_->as_read)
    for (const FacesAsRead::Triangle& t : data_->as_read->of(face))
      if (faces.empty() || faces.back() != t.source) faces.push_back(t.source);
  if (faces.empty()) faces.push_back(face);
  return faces;
}

}  // namespace sectile
