// The open segments between neighbouring contacts: two faces that cross, an edge in a face, an edge
// along an edge.
#include <algorithm>
#include <numeric>

#include "boolean/collect.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/standing.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using Where = Standing::Where;

// The places on an edge, in the order of its even half-edge.
class EdgeNodes {
 public:
  EdgeNodes(const Workspace& w, int solid) : w_(w), solid_(solid) {
    for (std::uint32_t i = 0; i < w.contacts.size(); ++i)
      if (w.contacts[i].on[solid].is_edge()) order_.push_back(i);
    const auto edge = [&](std::uint32_t i) { return w.contacts[i].on[solid].edge(); };
    std::stable_sort(order_.begin(), order_.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return edge(i) < edge(j); });
    for (std::size_t from = 0, to; from < order_.size(); from = to) {
      for (to = from + 1; to < order_.size() && edge(order_[to]) == edge(order_[from]);) ++to;
      if (to - from > 1) sort_along(edge(order_[from]), from, to);
    }
  }

  /// Indices of the contacts on an edge; those at one place are neighbours.
  std::span<const std::uint32_t> of(EdgeId e) const {
    const auto first = std::partition_point(order_.begin(), order_.end(), [&](std::uint32_t i) {
      return w_.contacts[i].on[solid_].edge() < e;
    });
    auto last = first;
    while (last != order_.end() && w_.contacts[*last].on[solid_].edge() == e) ++last;
    return {first, last};
  }

 private:
  void sort_along(EdgeId e, std::size_t from, std::size_t to) {
    const Patch& patch = w_.patch[solid_];
    const HalfEdgeId h = Brep::half_edge(e);
    const auto [a, b] = line_planes(patch, h);
    const int axis = w_.tests().cross_axis(a, b);
    const Sign along = w_.tests().compare(patch.brep.point_of(patch.brep.from(h)),
                                          patch.brep.point_of(patch.brep.to(h)), axis);
    std::sort(order_.begin() + static_cast<std::ptrdiff_t>(from),
              order_.begin() + static_cast<std::ptrdiff_t>(to),
              [&](std::uint32_t i, std::uint32_t j) {
                const std::uint32_t p = w_.contacts[i].place, q = w_.contacts[j].place;
                if (p == q) return i < j;
                return w_.tests().compare(w_.point(p), w_.point(q), axis) == along;
              });
  }

  const Workspace& w_;
  int solid_;
  std::vector<std::uint32_t> order_;
};

void emit(std::vector<SegmentRecord>& out, SegmentRecord r) {
  if (r.place[0] > r.place[1]) {
    std::swap(r.place[0], r.place[1]);
    for (auto& end : r.end) std::swap(end[0], end[1]);
  }
  out.push_back(r);
}

// Two faces in different planes: the common line enters and leaves both of them at contacts.
class CrossingFaces {
 public:
  CrossingFaces(const Workspace& w, const ContactTable& table, std::vector<SegmentRecord>& out)
      : w_(w), kernel_(w.tests()), table_(table), out_(out) {}

  void operator()(const PairOfFaces& pair) {
    pair_ = pair;
    points_.clear();
    edges_on_line_.clear();
    gather(0);
    gather(1);
    if (points_.size() < 2) return;
    merge_places();
    if (points_.size() < 2) return;
    const PlaneId a = w_.patch[0].plane(pair.face[0]), b = w_.patch[1].plane(pair.face[1]);
    const int axis = kernel_.cross_axis(a, b);
    const Sign along = kernel_.cross(a, b, axis);
    std::sort(points_.begin(), points_.end(), [&](const Point& p, const Point& q) {
      return kernel_.compare(w_.point(p.place), w_.point(q.place), axis) == along;
    });
    for (const EdgeOnLine& e : edges_on_line_) add_within(e, axis, along);
    // n(a) × n(b), as seen in the plane of each.
    direction_[0] = {b, Sign::positive};
    direction_[1] = {a, Sign::negative};
    for (std::size_t i = 0; i + 1 < points_.size(); ++i) between(points_[i], points_[i + 1]);
  }

 private:
  struct Point {
    std::uint32_t place;
    std::vector<BoundaryItem> items[2];
  };
  struct EdgeOnLine {
    int solid;
    HalfEdgeId h;
  };

  void gather(int s) {
    sided_.clear();
    sided_half_edges(w_, s, pair_.face[s], pair_.face[1 - s], sided_);
    const Brep& brep = w_.patch[s].brep;
    for (const SidedHalfEdge& i : sided_) {
      if (i.from == Sign::zero && i.to == Sign::zero) edges_on_line_.push_back({s, i.h});
      if (i.from == Sign::zero)
        add(s, table_.find(s, brep.from(i.h), pair_.face[1 - s]), i.h);
      else if (i.from * i.to == Sign::negative)
        add(s, table_.find(s, Brep::edge_of(i.h), pair_.face[1 - s]), i.h);
    }
  }

  // A face that touches itself may have places within an edge; the edge bounds it there too.
  void add_within(const EdgeOnLine& e, int axis, Sign along) {
    const Brep& brep = w_.patch[e.solid].brep;
    PointId from = brep.point_of(brep.from(e.h)), to = brep.point_of(brep.to(e.h));
    if (kernel_.compare(from, to, axis) != along) std::swap(from, to);
    const auto precedes = [&](PointId p, PointId q) {
      return kernel_.compare(p, q, axis) == along;
    };
    auto p = std::partition_point(points_.begin(), points_.end(), [&](const Point& i) {
      return !precedes(from, w_.point(i.place));
    });
    for (; p != points_.end() && precedes(w_.point(p->place), to); ++p) {
      auto& items = p->items[e.solid];
      items.push_back({Brep::edge_of(e.h), e.h});
      std::sort(items.begin(), items.end());
    }
  }

  void add(int s, std::span<const Hit> hits, HalfEdgeId h) {
    if (hits.empty()) return;
    Point point;
    point.place = w_.contacts[hits[0].contact].place;
    point.items[s].push_back({hits[0].piercer, h});
    for (const Hit& hit : hits)
      add_items(w_.patch[1 - s], pair_.face[1 - s], hit.found, point.items[1 - s]);
    points_.push_back(std::move(point));
  }

  void merge_places() {
    std::sort(points_.begin(), points_.end(),
              [](const Point& p, const Point& q) { return p.place < q.place; });
    std::size_t kept = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) {
      if (points_[i].place != points_[kept].place) {
        if (++kept != i) points_[kept] = std::move(points_[i]);
        continue;
      }
      for (int s = 0; s < 2; ++s) append(points_[kept].items[s], points_[i].items[s]);
    }
    points_.resize(kept + 1);
    for (Point& p : points_) {
      for (auto& items : p.items) {
        std::sort(items.begin(), items.end());
        items.erase(std::unique(items.begin(), items.end()), items.end());
      }
    }
  }

  void between(const Point& p, const Point& q) {
    SegmentRecord record;
    record.place[0] = p.place;
    record.place[1] = q.place;
    // Beside one of the faces, the other one may end anywhere.
    for (int s = 0; s < 2; ++s) {
      const Standing from = stands(s, p, direction_[s]);
      if (from.where != Where::inside) return;
      record.on[s] = pair_.face[s];
      record.end[s][0] = from.entity;
    }
    for (int s = 0; s < 2; ++s) {
      const Standing to = stands(s, q, -direction_[s]);
      if (to.where != Where::inside)
        throw InternalError("a line leaves a face without crossing its boundary");
      record.end[s][1] = to.entity;
    }
    emit(out_, record);
  }

  Standing stands(int s, const Point& p, const Direction& direction) const {
    return standing(kernel_, w_.patch[s], pair_.face[s], p.items[s], direction);
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const ContactTable& table_;
  std::vector<SegmentRecord>& out_;
  PairOfFaces pair_{};
  std::vector<SidedHalfEdge> sided_;
  std::vector<Point> points_;
  std::vector<EdgeOnLine> edges_on_line_;
  Direction direction_[2];
};

// An edge of solid s that lies in the plane of a face of the other solid.
class EdgeInPlane {
 public:
  EdgeInPlane(const Workspace& w, const ContactTable& table, const EdgeNodes& nodes, int s,
              std::vector<SegmentRecord>& out)
      : w_(w), kernel_(w.tests()), table_(table), nodes_(nodes), s_(s), out_(out) {}

  void operator()(const InPlane& pair) {
    const Patch& other = w_.patch[1 - s_];
    const HalfEdgeId h = Brep::half_edge(pair.edge);
    const Direction along = direction_in(other.plane(pair.face), h);
    find_nodes(pair, h);
    Standing at{Where::outside, {}, {}};
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      const auto& items = places_[i].items;
      if (!items.empty() || places_[i].inside)
        at = standing(kernel_, other, pair.face, items, along);
      else
        at.entity = carrier(at, pair.face);
      if (at.where == Where::outside) continue;
      SegmentRecord record;
      record.place[0] = places_[i].place;
      record.place[1] = places_[i + 1].place;
      record.on[s_] = pair.edge;
      record.on[1 - s_] = carrier(at, pair.face);
      record.end[s_][0] = places_[i].mine;
      record.end[s_][1] = places_[i + 1].mine;
      record.end[1 - s_][0] = at.entity;
      if (at.where == Where::along) pass_through(places_[i + 1], at.half_edge);
      record.end[1 - s_][1] = end_entity(places_[i + 1], at, pair.face, along);
      emit(out_, record);
    }
  }

 private:
  struct Node {
    std::uint32_t place;
    Entity mine;
    bool inside = false;
    std::vector<BoundaryItem> items;
  };

  static Entity carrier(const Standing& at, FaceId face) {
    return at.where == Where::along ? Entity(Brep::edge_of(at.half_edge)) : Entity(face);
  }

  Direction direction_in(PlaneId plane, HalfEdgeId h) const {
    const Brep& brep = w_.patch[s_].brep;
    const auto [a, b] = line_planes(w_.patch[s_], h);
    const PlaneId across = kernel_.parallel(plane, a) ? b : a;
    const int axis = kernel_.cross_axis(plane, across);
    const Sign sign = kernel_.compare(brep.point_of(brep.from(h)), brep.point_of(brep.to(h)), axis);
    return {across, sign * kernel_.cross(plane, across, axis)};
  }

  void find_nodes(const InPlane& pair, HalfEdgeId h) {
    places_.clear();
    const Brep& brep = w_.patch[s_].brep;
    add_end(pair, brep.from(h));
    for (const std::uint32_t i : nodes_.of(pair.edge)) {
      const Contact& c = w_.contacts[i];
      if (places_.empty() || places_.back().place != c.place)
        places_.push_back({c.place, pair.edge, false, {}});
      add(places_.back(), pair.face, c.on[1 - s_]);
    }
    add_end(pair, brep.to(h));
  }

  void add_end(const InPlane& pair, VertexId v) {
    const std::span<const Hit> hits = table_.find(s_, v, pair.face);
    if (hits.empty()) return;
    places_.push_back({w_.contacts[hits[0].contact].place, v, false, {}});
    for (const Hit& hit : hits) add(places_.back(), pair.face, hit.found);
  }

  void add(Node& node, FaceId face, Entity entity) {
    if (entity == Entity(face)) node.inside = true;
    add_items(w_.patch[1 - s_], face, entity, node.items);
    std::sort(node.items.begin(), node.items.end());
    node.items.erase(std::unique(node.items.begin(), node.items.end()), node.items.end());
  }

  // An edge of the face that does not end in a node bounds the face there too, even if the face
  // touches itself with something else.
  void pass_through(Node& node, HalfEdgeId h) const {
    if (node.items.empty()) return;
    const Brep& brep = w_.patch[1 - s_].brep;
    const Entity edge = Brep::edge_of(h), from = brep.from(h), to = brep.to(h);
    for (const BoundaryItem& item : node.items)
      if (item.entity == edge || item.entity == from || item.entity == to) return;
    node.items.push_back({edge, h});
    std::sort(node.items.begin(), node.items.end());
  }

  Entity end_entity(const Node& node, const Standing& at, FaceId face, Direction along) const {
    if (node.items.empty()) return carrier(at, face);
    if (at.where == Where::along) return end_along(w_.patch[1 - s_].brep, at.half_edge, node.items);
    return standing(kernel_, w_.patch[1 - s_], face, node.items, -along).entity;
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const ContactTable& table_;
  const EdgeNodes& nodes_;
  int s_;
  std::vector<SegmentRecord>& out_;
  std::vector<Node> places_;
};

}  // namespace

void find_segments(Workspace& w, const ContactTable& table) {
  using Records = std::vector<SegmentRecord>;
  for (const Records& r :
       collect<Records>(table.pairs.size(), 128, [&](std::size_t i, Records&out) {
         if (!table.pairs[i].coplanar) CrossingFaces(w, table, out)(table.pairs[i]);
       }))
    append(w.records, r);
  for (int s = 0; s < 2; ++s) {
    const EdgeNodes nodes(w, s);
    for (const Records& r :
         collect<Records>(table.in_plane[s].size(), 128, [&](std::size_t i, Records&out) {
           EdgeInPlane(w, table, nodes, s, out)(table.in_plane[s][i]);
         }))
      append(w.records, r);
  }
}

void reduce(Workspace& w, const FacePairs& candidates) {
  const ContactTable table = find_contacts(w, candidates);
  find_segments(w, table);
  split_at_places(w);
  if (add_crossings(w)) split_at_places(w);
  add_touched_faces(w, table);
}

}  // namespace sectile
