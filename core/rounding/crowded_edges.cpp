#include "rounding/crowded_edges.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "search/approximate.h"
#include "search/edges_by_line.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

using namespace approximate;

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
    std::vector<PieceTree::Edge> edges, corners;
    for (const Edge& e : edges_) edges.push_back({e.from, e.to});
    for (const Corner& c : corners_) corners.push_back({c.at, c.at});
    std::vector<std::uint32_t> edges_at(corners.size(), 0);
    PieceTree::overlaps(PieceTree(edges), PieceTree(corners),
                        [&](std::uint32_t e, std::uint32_t c) {
                          if (may_be_on(corners_[c], edges_[e])) ++edges_at[c];
                        });
    std::size_t on_edges = 0, times = 0;
    for (const std::uint32_t count : edges_at) {
      on_edges += count > 0 ? 1 : 0;
      times += count;
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
    all.erase(std::ranges::unique(all, {}, key).begin(), all.end());
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
