// The open segments between neighbouring contacts: two faces that cross, an edge in a face, an edge
// along an edge.
#include <algorithm>
#include <cmath>
#include <functional>

#include "boolean/collect.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/crossing_faces.h"
#include "boolean/reduction/crowded_segments.h"
#include "boolean/reduction/rows_on_lines.h"
#include "boolean/reduction/standing.h"
#include "geometry/axes.h"
#include "numbers/threshold.h"
#include "search/bucket_sort.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

using Where = Standing::Where;

// The places on an edge, in the order of its even half-edge.
class EdgeNodes {
 public:
  EdgeNodes(const Workspace& w, const Contacts& found, Operand solid)
      : w_(w), found_(found), solid_(solid) {
    for (const ContactId i : found.contacts.ids())
      if (found.contacts[i].on[solid].is_edge()) order_.push_back(i);
    first_ = bucket_sort(
        order_, w.patch[solid].brep.edge_count(),
        [&](ContactId i) { return found.contacts[i].on[solid].edge().value(); }, std::less<>());
    by_entity_.resize(order_.size());
    for (const EdgeId e : w.patch[solid].brep.edges()) {
      const std::uint32_t count = first_[e.value() + 1] - first_[e.value()];
      if (count > 1) sort_along(e);
      if (count > few_nodes) sort_by_entity(e);
    }
  }

  /// Indices of the contacts on an edge, but for some that are not in the box; those at one place
  /// are neighbours.
  std::span<const ContactId> near(EdgeId e, const Box& box) const {
    const std::span<const ContactId> nodes = on(e, order_);
    return nodes.size() < 2 ? nodes : within(nodes, box);
  }

  /// So many are looked at one by one.
  static constexpr std::size_t few_nodes = threshold(16, 2);

  /// Of more than a few on an edge, those with a face of few corners, its edges and its vertices;
  /// else as near().
  std::span<const ContactId> with(FaceId face, EdgeId e, std::vector<ContactId>& found) const {
    const Patch& patch = w_.patch[other(solid_)];
    const Brep& across = patch.brep;
    std::vector<std::uint32_t> at;
    const auto add = [&](Entity entity) {
      const std::span<const Across> nodes = on(e, by_entity_);
      for (auto node = std::ranges::lower_bound(nodes, entity, {}, &Across::entity);
           node != nodes.end() && node->entity == entity; ++node)
        at.push_back(node->at);
    };
    add(face);
    for_each_in_face(across, face, [&](HalfEdgeId h) {
      add(Brep::edge_of(h));
      add(across.from(h));
      add(patch.tested(across.from(h)));
    });
    std::sort(at.begin(), at.end());
    at.erase(std::unique(at.begin(), at.end()), at.end());
    found.clear();
    for (const std::uint32_t i : at) found.push_back(order_[i]);
    return found;
  }

 private:
  // What an edge meets in one of its nodes.
  struct Across {
    Entity entity;
    std::uint32_t at;  // in the order along the edges
    friend auto operator<=>(const Across&, const Across&) = default;
  };

  template <class T>
  std::span<const T> on(EdgeId e, const std::vector<T>& nodes) const {
    return std::span(nodes).subspan(first_[e.value()], first_[e.value() + 1] - first_[e.value()]);
  }

  void sort_by_entity(EdgeId e) {
    const std::uint32_t first = first_[e.value()], last = first_[e.value() + 1];
    for (std::uint32_t i = first; i < last; ++i)
      by_entity_[i] = {found_.contacts[order_[i]].on[other(solid_)], i};
    std::sort(by_entity_.begin() + first, by_entity_.begin() + last);
  }

  void sort_along(EdgeId e) {
    const Patch& patch = w_.patch[solid_];
    const HalfEdgeId h = Brep::half_edge(e);
    const auto [a, b] = line_planes(patch, h);
    const int axis = w_.tests().cross_axis(a, b);
    const Sign along = w_.tests().compare(patch.brep.point_of(patch.brep.from(h)),
                                          patch.brep.point_of(patch.brep.to(h)), axis);
    std::sort(order_.begin() + first_[e.value()], order_.begin() + first_[e.value() + 1],
              [&](ContactId i, ContactId j) {
                const PlaceId p = found_.contacts[i].place, q = found_.contacts[j].place;
                if (p == q) return i < j;
                return w_.tests().compare(found_.point(p), found_.point(q), axis) == along;
              });
  }

  // Rounding is monotonic: the rounded positions, too, are in order on each axis.
  std::span<const ContactId> within(std::span<const ContactId> nodes, const Box& box) const {
    const auto position = [&](ContactId i) -> const Vec3& {
      return w_.geometry.position(found_.point(found_.contacts[i].place));
    };
    const Vec3 &from = position(nodes.front()), &to = position(nodes.back());
    int axis = 0;
    for (const int k : {1, 2})
      if (std::abs(component(to, k) - component(from, k)) >
          std::abs(component(to, axis) - component(from, axis)))
        axis = k;
    const bool ascending = component(from, axis) <= component(to, axis);
    const auto precedes = [&](ContactId i) {
      const double at = component(position(i), axis);
      return ascending ? at < box.low[axis] : at > box.high[axis];
    };
    const auto follows_not = [&](ContactId i) {
      const double at = component(position(i), axis);
      return ascending ? at <= box.high[axis] : at >= box.low[axis];
    };
    const auto first = std::partition_point(nodes.begin(), nodes.end(), precedes);
    return {first, std::partition_point(first, nodes.end(), follows_not)};
  }

  const Workspace& w_;
  const Contacts& found_;
  Operand solid_;
  std::vector<ContactId> order_;      // by edge, then along it
  std::vector<Across> by_entity_;     // by edge, then by entity, for edges with many nodes
  std::vector<std::uint32_t> first_;  // per edge, and the end
};

// An edge of solid s that lies in the plane of a face of the other solid.
class EdgeInPlane {
 public:
  EdgeInPlane(const Workspace& w, const Contacts& found, const ContactTable& table,
              const EdgeNodes& nodes, Operand s, SegmentRecords& out)
      : w_(w), kernel_(w.tests()), found_(found), table_(table), nodes_(nodes), s_(s), out_(out) {}

  void operator()(const InPlane& pair) {
    const Patch& across = w_.patch[other(s_)];
    const HalfEdgeId h = Brep::half_edge(pair.edge);
    const Direction along = direction_in(across.plane(pair.face), h);
    find_nodes(pair, h);
    Standing at{Where::outside, {}, {}};
    for (std::size_t i = 0; i + 1 < used_; ++i) {
      const auto& items = places_[i].items;
      if (!items.empty() || places_[i].inside)
        at = standing(kernel_, across, pair.face, items, along);
      else
        at.entity = carrier(at, pair.face);
      if (at.where == Where::outside) continue;
      SegmentRecord record;
      record.place[0] = places_[i].place;
      record.place[1] = places_[i + 1].place;
      record.on[s_] = pair.edge;
      record.on[other(s_)] = carrier(at, pair.face);
      record.end[s_][0] = places_[i].mine;
      record.end[s_][1] = places_[i + 1].mine;
      record.end[other(s_)][0] = at.entity;
      if (at.where == Where::along) pass_through(places_[i + 1], at.half_edge);
      record.end[other(s_)][1] = end_entity(places_[i + 1], at, pair.face, along);
      record.put_in_order();
      out_.push_back(record);
    }
  }

 private:
  struct Node {
    PlaceId place;
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
    return direction_between(kernel_, plane, across, brep.point_of(brep.from(h)),
                             brep.point_of(brep.to(h)));
  }

  void find_nodes(const InPlane& pair, HalfEdgeId h) {
    used_ = 0;
    const Brep& brep = w_.patch[s_].brep;
    const Patch& across = w_.patch[other(s_)];
    const Box near = across.unbounded ? Box::everything() : across.face_boxes[pair.face.value()];
    add_end(pair, brep.from(h));
    for (const ContactId i : contacts_on(pair, near)) {
      const Contact& c = found_.contacts[i];
      if (used_ == 0 || places_[used_ - 1].place != c.place) begin_node(c.place, pair.edge);
      add(places_[used_ - 1], pair.face, c.on[other(s_)]);
    }
    add_end(pair, brep.to(h));
  }

  // Other faces' contacts divide the edge, too, but that can be made up for: where the edge is one
  // of many in one place, each has contacts with all the others.
  std::span<const ContactId> contacts_on(const InPlane& pair, const Box& near) {
    const EdgeId tested = w_.patch[s_].tested(pair.edge);
    const std::span<const ContactId> nodes = nodes_.near(tested, near);
    const bool many =
        nodes.size() > EdgeNodes::few_nodes && !w_.patch[other(s_)].outline(pair.face);
    return many ? nodes_.with(pair.face, tested, of_face_) : nodes;
  }

  void add_end(const InPlane& pair, VertexId v) {
    const std::span<const Hit> hits = table_.find(s_, w_.patch[s_].tested(v), pair.face);
    if (hits.empty()) return;
    begin_node(found_.contacts[hits[0].contact].place, v);
    for (const Hit& hit : hits) add(places_[used_ - 1], pair.face, hit.found);
  }

  void begin_node(PlaceId place, Entity mine) {
    if (used_ == places_.size()) places_.emplace_back();
    Node& node = places_[used_++];
    node.place = place;
    node.mine = mine;
    node.inside = false;
    node.items.clear();
  }

  void add(Node& node, FaceId face, Entity entity) {
    const Patch& across = w_.patch[other(s_)];
    if (entity == Entity(face)) node.inside = true;
    if (entity.is_vertex() && across.tested.any())
      add_corners_at(node, face, across.tested(entity.vertex()));
    else
      add_items(across, face, entity, node.items);
    std::sort(node.items.begin(), node.items.end());
    node.items.erase(std::unique(node.items.begin(), node.items.end()), node.items.end());
  }

  // The face's corners in the place of a vertex that was tested for them.
  void add_corners_at(Node& node, FaceId face, VertexId tested) {
    const Patch& across = w_.patch[other(s_)];
    const auto add = [&](HalfEdgeId h) {
      const VertexId v = across.brep.from(h);
      if (across.tested(v) == tested) node.items.push_back({v, h});
    };
    const CrowdedCorners* const crowded =
        across.crowded.empty() ? nullptr : across.crowded_corners(face);
    if (!crowded) return for_each_in_face(across.brep, face, add);
    const PieceTree place(std::span(&w_.geometry.position(across.brep.point_of(tested)), 1));
    for (const CrowdedCorners::Fan& fan : crowded->fans()) {
      const auto is_tested = [&](VertexId v) { return across.tested(v) == tested; };
      if (std::ranges::any_of(fan.vertices, is_tested))
        node.items.push_back({fan.vertices[0], HalfEdgeId()});
      else
        CrowdedCorners::query(fan, place, add);
    }
    crowded->query_others(place, add);
  }

  // An edge of the face that does not end in a node bounds the face there too, even if the face
  // touches itself with something else.
  void pass_through(Node& node, HalfEdgeId h) const {
    if (node.items.empty()) return;
    const Patch& across = w_.patch[other(s_)];
    const Entity edge = Brep::edge_of(h);
    const VertexId from = across.brep.from(h), to = across.brep.to(h);
    for (const BoundaryItem& item : node.items)
      if (item.entity == edge || is_of(across, across.brep.face_of(h), item, from) ||
          is_of(across, across.brep.face_of(h), item, to))
        return;
    node.items.push_back({edge, h});
    std::sort(node.items.begin(), node.items.end());
  }

  Entity end_entity(const Node& node, const Standing& at, FaceId face, Direction along) const {
    if (node.items.empty()) return carrier(at, face);
    if (at.where == Where::along) return end_along(w_.patch[other(s_)], at.half_edge, node.items);
    return standing(kernel_, w_.patch[other(s_)], face, node.items, -along).entity;
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& found_;
  const ContactTable& table_;
  const EdgeNodes& nodes_;
  Operand s_;
  SegmentRecords& out_;
  std::vector<Node> places_;  // those used are of this edge; the others are kept for their memory
  std::size_t used_ = 0;
  std::vector<ContactId> of_face_;  // of the pair that is looked at
};

}  // namespace

void find_segments(const Workspace& w, const ContactTable& table, Contacts& found) {
  found.segments = joined(collect_ranges<SegmentRecords>(
      w, table.pairs.size(), 128, [&](std::size_t first, std::size_t last, SegmentRecords& out) {
        out.reserve(last - first);
        CrossingFaces cross(w, found, table, out);
        for (std::size_t i = first; i < last; ++i)
          if (!table.pairs[i].coplanar) cross(table.pairs[i]);
      }));
  for (const Operand s : both_operands) {
    if (table.in_plane[s].empty()) continue;
    const EdgeNodes nodes(w, found, s);
    append(found.segments, joined(collect_ranges<SegmentRecords>(
                               w, table.in_plane[s].size(), 128,
                               [&](std::size_t first, std::size_t last, SegmentRecords& out) {
                                 EdgeInPlane edge(w, found, table, nodes, s, out);
                                 for (std::size_t i = first; i < last; ++i)
                                   edge(table.in_plane[s][i]);
                               })));
  }
}

namespace {

// Edges of which one face lies deep in what is common to both boundaries have no segments.
void leave_out_open_edges(const Workspace& w, Contacts& found) {
  if (w.common_faces.empty()) return;
  const auto is_open = [&](const SegmentRecord& r, Operand s) {
    if (!r.on[s].is_edge()) return false;
    const Patch& patch = w.patch[s];
    const HalfEdgeId h = Brep::half_edge(r.on[s].edge());
    return !patch.is_real(patch.brep.face_of(h)) ||
           !patch.is_real(patch.brep.face_of(Brep::twin(h)));
  };
  std::erase_if(found.segments, [&](const SegmentRecord& r) {
    return is_open(r, Operand::a) || is_open(r, Operand::b);
  });
}

}  // namespace

Contacts reduce(Workspace& w, const FacePairs& candidates) {
  Contacts found;
  const ContactTable table = find_contacts(w, candidates, found);
  find_segments(w, table, found);
  leave_out_open_edges(w, found);
  if (w.crowded_lines.empty() && !w.options.observer) mark_crowded_segments(w, found);
  make_rows(w, table, found);
  divide_rows(w, found);
  split_at_places(w, found);
  if (add_crossings(w, found)) split_at_places(w, found);
  add_touched_faces(w, table, found);
  return found;
}

}  // namespace sectile
