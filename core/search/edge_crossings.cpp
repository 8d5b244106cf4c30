#include "search/edge_crossings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

#include "numbers/threshold.h"
#include "search/approximate.h"
#include "search/box_tree.h"

namespace sectile {
namespace {

using namespace approximate;

// So many edges that cross one in one point are a crowd.
constexpr std::size_t least_crossing = threshold(16, 2);
constexpr std::size_t looks_for_each = threshold(16, 256);

using Edge = SidedPolygons::Side;

// Asks some polygons which others cross their edges, and where.
class CrossingFinder {
 public:
  CrossingFinder(const Kernel& kernel, const SidedPolygons& polygons)
      : kernel_(kernel), polygons_(polygons), boxes_(boxes()), tree_(boxes_) {}

  std::vector<Construction> run() {
    constexpr std::size_t stride = 0x9E3779B1;  // a prime: polygons beside each other are alike
    const std::size_t count = polygons_.count();
    for (std::size_t i = 0; i < count && looks_ < looks_for_each * count; ++i)
      look_around(i * stride % count);
    return by_frequency();
  }

 private:
  struct Hit {
    double at;  // part of the edge
    std::size_t polygon;
  };
  struct Found {
    Vec3 position;
    Construction how;
    std::size_t times = 1;
  };

  std::vector<Box> boxes() const {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < polygons_.count(); ++i) {
      Bounds bounds;
      for (const SidedPolygons::Side& side : polygons_.sides(i)) bounds.add(at(side.from));
      boxes.push_back(bounds.box());
    }
    return boxes;
  }
  const Vec3& at(PointId p) const { return kernel_.geometry().position(p); }

  void look_around(std::size_t polygon) {
    near_.clear();
    tree_.query([&](const Box& box) { return box.overlaps(boxes_[polygon]); },
                [&](std::uint32_t i) {
                  if (i != polygon && polygons_.may_meet(polygon, i)) near_.push_back(i);
                });
    looks_ += 1 + near_.size();
    if (near_.size() < least_crossing) return;
    for (const SidedPolygons::Side& side : polygons_.sides(polygon))
      find_on(side, polygons_.plane(polygon));
  }

  void find_on(const Edge& edge, PlaneId plane) {
    // What is nearer in doubles is one point, or exact tests tell it apart.
    constexpr double alike = 0x1p-36;
    hits_.clear();
    for (const std::uint32_t i : near_)
      for (const SidedPolygons::Side& side : polygons_.sides(i))
        if (const auto where = crossing(edge, side.from, side.to)) hits_.push_back({*where, i});
    std::ranges::sort(hits_, {}, [](const Hit& hit) { return std::pair(hit.at, hit.polygon); });
    for (std::size_t first = 0, last; first < hits_.size(); first = last) {
      for (last = first + 1; last < hits_.size() && hits_[last].at - hits_[last - 1].at < alike;)
        ++last;
      if (last - first >= least_crossing) add(edge, plane, hits_[(first + last) / 2].polygon);
    }
  }

  // Where another edge crosses one within both, as far as doubles tell.
  std::optional<double> crossing(const Edge& edge, PointId from, PointId to) const {
    constexpr double near = 0x1p-36, least_sine = 0x1p-20;
    if (from == edge.from || from == edge.to || to == edge.from || to == edge.to) return {};
    const Vec3 along = at(edge.to) - at(edge.from), across = at(to) - at(from),
               between = at(from) - at(edge.from), normal = cross(along, across);
    const double square = dot(normal, normal), sizes = dot(along, along) * dot(across, across);
    if (!(square > least_sine * least_sine * sizes)) return {};
    const double where = dot(cross(between, across), normal) / square,
                 beyond = dot(cross(between, along), normal) / square;
    if (!(where > 0 && where < 1 && beyond > 0 && beyond < 1)) return {};
    const double off = dot(between, normal);
    if (off * off > near * near * square * std::max(dot(along, along), dot(across, across)))
      return {};
    return where;
  }

  // Through a point of the edge runs a face of the polygon.
  void add(const Edge& edge, PlaneId plane, std::size_t polygon) {
    const PlaneId across = polygons_.plane(polygon);
    if (!edge.beyond.valid() || kernel_.det(plane, edge.beyond, across) == Sign::zero) return;
    const Geometry& geometry = kernel_.geometry();
    Construction how{plane, edge.beyond, across, {}, {}};
    if (!geometry.is_constructed(edge.from) && !geometry.is_constructed(edge.to)) {
      how.line_from = edge.from;
      how.line_to = edge.to;
    }
    found_.push_back({kernel_.construct(how).position, how});
  }

  std::vector<Construction> by_frequency() {
    const auto coordinates = [](const Found& f) {
      return std::tuple(f.position.x, f.position.y, f.position.z);
    };
    std::ranges::stable_sort(found_, {}, coordinates);
    std::vector<Found> places;
    for (const Found& found : found_) {
      if (!places.empty() && places.back().position == found.position)
        ++places.back().times;
      else
        places.push_back(found);
    }
    std::ranges::stable_sort(places, std::ranges::greater(), &Found::times);
    std::vector<Construction> crossings;
    for (const Found& place : places) crossings.push_back(place.how);
    return crossings;
  }

  const Kernel& kernel_;
  const SidedPolygons& polygons_;
  std::vector<Box> boxes_;
  BoxTree tree_;
  std::size_t looks_ = 0;
  std::vector<std::uint32_t> near_;
  std::vector<Hit> hits_;
  std::vector<Found> found_;
};

}  // namespace

std::vector<Construction> crowded_crossings(const Kernel& kernel, const SidedPolygons& polygons) {
  return CrossingFinder(kernel, polygons).run();
}

}  // namespace sectile
