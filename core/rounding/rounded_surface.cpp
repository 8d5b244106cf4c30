#include "rounding/rounded_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "numbers/none.h"
#include "parallel/parallel.h"
#include "rounding/common_lines.h"
#include "rounding/conforming.h"
#include "rounding/line_separation.h"
#include "selftest/solid_surface.h"

namespace sectile {
namespace {

void require_finite(const Vec3& rounded, const Vec3& exact) {
  if (!std::isfinite(rounded.x) || !std::isfinite(rounded.y) || !std::isfinite(rounded.z))
    throw RoundingFailed("a coordinate is too large for the numbers of the mesh", exact);
}

}  // namespace

RoundedSurface::RoundedSurface(const SolidData& data, const RoundingGrid& grid, Lines lines,
                               const SelfTestControl& control) {
  const auto step = [&](double done) {
    if (control.cancel && control.cancel->load(std::memory_order_relaxed)) throw Cancelled();
    if (control.progress) control.progress(done);
  };
  step(0);
  const Brep& brep = data.brep();
  step(0.05);
  const Kernel kernel(data.geometry());
  std::vector<FaceId> crossing;
  surface = surface_of(brep, kernel, crossing);
  if (!crossing.empty()) throw InternalError("the edges of a solid's face cross each other");
  step(0.5);
  make_conforming(surface, kernel);
  const Geometry* exact = &data.geometry();
  const auto moves = [&](PointId p) {
    const Vec3& at = exact->position(p);
    return !exact->is_explicit(p) || !(grid.nearest(at) == at);
  };
  std::vector<CornerOnEdge> on_edges = corners_on_edges(surface, kernel, moves);
  Geometry geometry_apart;
  std::optional<Kernel> kernel_apart;
  std::vector<LineSeparation::Separated> separated;
  if (lines == Lines::apart && are_crowded(on_edges)) {
    geometry_apart = *exact;
    exact = &geometry_apart;
    LineSeparation apart(surface, geometry_apart, kernel_apart.emplace(geometry_apart), grid);
    apart.run(on_edges);
    separated.assign(apart.separated().begin(), apart.separated().end());
    on_edges = corners_on_edges(surface, *kernel_apart, moves);
  }
  for (const LineSeparation::Separated& end : separated)
    if (!(exact->position(end.point) == grid.nearest(exact->position(end.from)))) ++moved_apart_;
  divide_on_common_lines(surface, kernel_apart ? *kernel_apart : kernel, moves, on_edges);
  step(0.55);
  const auto place_of = [&](PointId p) {
    const auto at = std::ranges::lower_bound(separated, p, {}, &LineSeparation::Separated::point);
    return at != separated.end() && at->point == p ? at->from : p;
  };
  std::vector<std::uint32_t> number(exact->positions.size(), none);
  std::vector<std::uint8_t> has_moved;
  corners.resize(surface.size());
  source.resize(surface.size());
  alive.assign(surface.size(), 1);
  for (std::size_t t = 0; t < surface.size(); ++t) {
    if (t % 0x10000 == 0) step(0.55 + 0.35 * double(t) / double(surface.size()));
    for (std::size_t k = 0; k < 3; ++k) {
      const PointId p = surface.corners[t][k];
      std::uint32_t& v = number[p.value()];
      if (v == none) {
        v = static_cast<std::uint32_t>(origin.size());
        const PointId place = place_of(p);
        const Vec3& at = exact->position(place);
        const Vec3 rounded = grid.nearest(exact->position(p));
        require_finite(rounded, at);
        origin.push_back(at);
        is_exact.push_back(exact->is_explicit(place));
        point.push_back(geometry.add_point(rounded));
        has_moved.push_back(!is_exact.back() || !(rounded == at));
        is_apart_.push_back(place != p);
        if (has_moved.back() != 0) moved_ = true;
      }
      corners[t][k] = v;
      surface.corners[t][k] = point[v];
    }
  }
  step(0.9);
  geometry.planes.resize(surface.size());
  surface.settled.resize(surface.size());
  parallel::loop(parallel::Range<std::size_t>(0, surface.size(), 4096), [&](const auto& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      source[t] = brep.source[FaceId(surface.face[t])];
      const auto& c = surface.corners[t];
      geometry.planes[PlaneId(t)] = PlaneDefinition::through(c[0], c[1], c[2]);
      surface.plane[t] = PlaneId(t);
      surface.face[t] = static_cast<std::uint32_t>(t);
      const Corners& v = corners[t];
      surface.settled[t] = !(has_moved[v[0]] || has_moved[v[1]] || has_moved[v[2]]);
    }
  });
  surface.doubtful.clear();
  step(1);
}

}  // namespace sectile
