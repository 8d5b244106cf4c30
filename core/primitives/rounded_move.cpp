#include <algorithm>
#include <numeric>

#include "import/soup.h"
#include "sectile/rounded_move.h"

namespace sectile {
namespace {

bool all_given(const SolidData& data) {
  const Geometry& geometry = data.geometry();
  return std::all_of(data.brep().point.begin(), data.brep().point.end(),
                     [&](PointId p) { return geometry.is_explicit(p); });
}

void add_loop(const Brep& brep, LoopId loop, Soup& soup) {
  const std::size_t first = soup.indices.size();
  for_each_in_loop(brep, loop, [&](HalfEdgeId h) { soup.indices.push_back(brep.from(h).value()); });
  soup.loop_sizes.push_back(static_cast<std::uint32_t>(soup.indices.size() - first));
  ++soup.face_loops.back();
}

Soup moved_faces(const SolidData& data, const Vec3& by) {
  const Brep& brep = data.brep();
  Soup soup;
  soup.positions.reserve(brep.vertex_count());
  for (const PointId point : brep.point) {
    const Vec3& p = data.geometry().position(point);
    soup.positions.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
  }
  for (const LoopId outer : brep.outer_loop) {
    soup.face_loops.push_back(0);
    for (LoopId l = outer; l.valid(); l = brep.next_loop[l.value()]) add_loop(brep, l, soup);
  }
  return soup;
}

}  // namespace

std::optional<Solid> rounded_move(const Solid& solid, const Vec3& by) {
  if (solid.is_empty()) return solid;
  const std::shared_ptr<const SolidData> data = solid.data();
  if (!all_given(*data)) return {};
  std::vector<std::uint32_t> each(data->brep().face_count());
  std::iota(each.begin(), each.end(), 0u);
  ImportOptions apart;
  apart.face_groups = each;
  const std::shared_ptr<const SolidData> imported = import_soup(moved_faces(*data, by), apart);
  auto image = std::make_shared<SolidData>();
  image->brep() = imported->brep();
  image->geometry() = imported->geometry();
  image->origin = data->origin;
  for (FaceSource& source : image->brep().source) source = data->brep().source[source.face];
  image->cut();
  return Solid(std::shared_ptr<const SolidData>(std::move(image)));
}

}  // namespace sectile
