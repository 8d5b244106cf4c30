#include "rounding/crowded_edges.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "search/approximate.h"
#include "search/box_index.h"
#include "search/edges_by_line.h"

namespace sectile {
namespace {

using namespace approximate;

// Where very many edges are near a corner, some tell enough.
constexpr std::size_t most_looks = 64;

class CrowdedEdges {
 public:
  CrowdedEdges(std::span<const PlacedTriangle> triangles, double slack) : slack_(slack) {
    for (const PlacedTriangle& t : triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = k < 2 ? k + 1 : 0;
        corners_.push_back({t.vertex[k], t.at[k]});
        edges_.push_back({PointPair::between(t.vertex[k], t.vertex[next]), t.at[k], t.at[next]});
      }
    keep_each_once(corners_, &Corner::vertex);
    keep_each_once(edges_, &Edge::ends);
  }

  bool found() const {
    std::vector<Box> boxes;
    for (const Edge& e : edges_) boxes.push_back(box_around(e.from, e.to));
    const BoxIndex index(boxes);
    std::size_t on_edges = 0, times = 0;
    for (const Corner& corner : corners_) {
      std::size_t looks = 0, found = 0;
      index.overlapping(box_around(corner.at, corner.at), [&](std::uint32_t e) {
        found += may_be_on(corner, edges_[e]) ? 1 : 0;
        return ++looks < most_looks;
      });
      on_edges += found > 0 ? 1 : 0;
      times += found;
    }
    return times > 2 * on_edges;
  }

 private:
  struct Corner {
    std::uint32_t vertex;
    Vec3 at;
  };
  struct Edge {
    PointPair ends;
    Vec3 from, to;
  };

  template <class T, class Key>
  static void keep_each_once(std::vector<T>& all, Key key) {
    std::ranges::sort(all, {}, key);
    const auto again = std::unique(all.begin(), all.end(), [&](const T& p, const T& q) {
      return std::invoke(key, p) == std::invoke(key, q);
    });
    all.erase(again, all.end());
  }

  bool may_be_on(const Corner& corner, const Edge& edge) const {
    if (corner.vertex == edge.ends.from || corner.vertex == edge.ends.to) return false;
    const Vec3 way = edge.to - edge.from, part = corner.at - edge.from;
    if (!(dot(way, part) > 0 && dot(way, part) < dot(way, way))) return false;
    const PlacedTriangle between{{edge.ends.from, edge.ends.to, corner.vertex},
                                 {edge.from, edge.to, corner.at}};
    return !ViewedTriangle(between, slack_).view.clear();
  }

  double slack_;
  std::vector<Corner> corners_;
  std::vector<Edge> edges_;
};

}  // namespace

bool have_crowded_edges(std::span<const PlacedTriangle> triangles, double slack) {
  return CrowdedEdges(triangles, slack).found();
}

}  // namespace sectile
