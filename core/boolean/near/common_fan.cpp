#include "boolean/near/common_fan.h"

#include <algorithm>
#include <tuple>

namespace sectile {
namespace {

class OwnerPairs {
 public:
  OwnerPairs(Workspace& w, Operand operand, const CommonFan& fan)
      : w_(w),
        patch_(w.patch[operand]),
        across_(w.patch[other(operand)]),
        fan_(fan),
        mine_(fan.of[operand]),
        others_(fan.of[other(operand)]) {}

  FacePairs run() {
    find_vertices();
    choose_vertices();
    if (fan_.line) choose_edges();
    return std::move(pairs_);
  }

 private:
  // A vertex at one of the places.
  struct At {
    std::size_t place;
    VertexId v;
  };
  // An edge between two of them, and what is tested for its ends.
  struct Edge {
    VertexId from, to;
    EdgeId e;
    friend auto operator<=>(const Edge&, const Edge&) = default;
  };

  const Vec3& position(VertexId v) const { return w_.geometry.position(patch_.brep.point_of(v)); }

  template <class Visit>
  void for_each_half_edge(const Visit& visit) const {
    for (const FaceId f : mine_.faces) for_each_in_face(patch_.brep, loaded_face(patch_, f), visit);
  }

  void find_vertices() {
    std::vector<Vec3> places = fan_.places;
    const auto key = [](const Vec3& p) { return std::tie(p.x, p.y, p.z); };
    std::ranges::sort(places, {}, key);
    for_each_half_edge([&](HalfEdgeId h) {
      const VertexId v = patch_.brep.from(h);
      const auto at = std::ranges::lower_bound(places, key(position(v)), {}, key);
      if (at != places.end() && *at == position(v))
        vertices_.push_back({static_cast<std::size_t>(at - places.begin()), v});
    });
    const auto order = [](const At& i) { return std::pair(i.place, i.v); };
    std::ranges::sort(vertices_, {}, order);
    const auto again = std::unique(vertices_.begin(), vertices_.end(),
                                   [&](const At& a, const At& b) { return order(a) == order(b); });
    vertices_.erase(again, vertices_.end());
  }

  // One of the vertices for each point at a rounded place: as a rule, there is one point.
  void choose_vertices() {
    for (std::size_t from = 0, to; from < vertices_.size(); from = to) {
      std::vector<VertexId> chosen;
      for (to = from; to < vertices_.size() && vertices_[to].place == vertices_[from].place; ++to)
        choose(vertices_[to].v, chosen);
      for (const VertexId v : chosen) add_pairs(patch_.owner(v), std::span(&position(v), 1));
    }
    std::ranges::sort(vertices_, {}, &At::v);
  }
  void choose(VertexId v, std::vector<VertexId>& chosen) {
    const auto at = std::ranges::find_if(chosen, [&](VertexId t) {
      return w_.tests().same_point(patch_.brep.point_of(t), patch_.brep.point_of(v));
    });
    if (at == chosen.end())
      chosen.push_back(patch_.tested(v));
    else
      patch_.tested.set(v, *at);
  }

  // Edges with the same ends: half-edge 0 of both runs the same way.
  void choose_edges() {
    std::vector<Edge> edges;
    for_each_half_edge([&](HalfEdgeId h) {
      const HalfEdgeId even = Brep::half_edge(Brep::edge_of(h));
      const VertexId from = patch_.brep.from(even), to = patch_.brep.to(even);
      if (is_at_place(from) && is_at_place(to))
        edges.push_back({patch_.tested(from), patch_.tested(to), Brep::edge_of(h)});
    });
    std::ranges::sort(edges);
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const Edge& edge = edges[i];
      if (i > 0 && edge.from == edges[i - 1].from && edge.to == edges[i - 1].to) {
        patch_.tested.set(edge.e, edges[i - 1].e);
        continue;
      }
      const Vec3 ends[] = {position(edge.from), position(edge.to)};
      add_pairs(patch_.owner(edge.e), ends);
    }
  }
  bool is_at_place(VertexId v) const {
    return std::ranges::binary_search(vertices_, v, {}, &At::v);
  }

  void add_pairs(FaceId owner, std::span<const Vec3> points) {
    const Box extent = fan_.line ? fan_.line->reach(points) : Box::everything();
    for (std::size_t i = 0; i < others_.faces.size(); ++i)
      if (!fan_.line || others_.boxes[i].overlaps(extent))
        pairs_.push_back({owner, loaded_face(across_, others_.faces[i])});
  }

  Workspace& w_;
  Patch& patch_;
  const Patch& across_;
  const CommonFan& fan_;
  const Fan &mine_, &others_;
  std::vector<At> vertices_;  // by place, then by vertex
  FacePairs pairs_;
};

}  // namespace

FacePairs pairs_of_owners(Workspace& w, Operand operand, const CommonFan& fan) {
  return OwnerPairs(w, operand, fan).run();
}

}  // namespace sectile
