// An operand may touch itself where two of its edges cross. If both lie in the plane of a face of
// the other operand, no test of a pair has seen the point: it becomes a place here.
#include <algorithm>

#include "boolean/collect.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/edges_by_faces.h"
#include "geometry/probe.h"
#include "numbers/threshold.h"
#include "search/edge_fans.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

struct Crossing {
  PerOperand<std::uint32_t> record;
  Construction how;
};

// Segments of edges of solid s in the interior of faces of the other one.
class CrossingEdges {
 public:
  CrossingEdges(const Workspace& w, const Contacts& found, Operand s)
      : w_(w), kernel_(w.tests()), found_(found), s_(s), order_(edges_by_faces(found, s)) {
    for (std::size_t from = 0, to; from < order_.size(); from = to) {
      for (to = from + 1; to < order_.size() && face(order_[to]) == face(order_[from]);) ++to;
      if (to - from > 1) groups_.push_back(std::span(order_).subspan(from, to - from));
    }
  }

  std::size_t groups() const { return groups_.size(); }

  void operator()(std::size_t group, std::vector<Crossing>& out) const {
    const std::span<const std::uint32_t> records = groups_[group];
    if (records.size() <= few) {
      for (std::size_t i = 0; i < records.size(); ++i)
        for (std::size_t j = i + 1; j < records.size(); ++j) cross(records[i], records[j], out);
      return;
    }
    std::vector<PieceTree::Edge> edges;
    std::vector<EdgeFans::Ends> ends;
    edges.reserve(records.size());
    ends.reserve(records.size());
    for (const std::uint32_t r : records) {
      edges.push_back({w_.geometry.position(end(r, 0)), w_.geometry.position(end(r, 1))});
      const PlaceId* const place = found_.segments[r].place;
      ends.push_back({place[0].value(), place[1].value()});
    }
    PieceTree(edges, EdgeFans(ends).of_edge()).self_overlaps([&](std::uint32_t i, std::uint32_t j) {
      cross(records[std::min(i, j)], records[std::max(i, j)], out);
    });
  }

 private:
  static constexpr std::size_t few = threshold(8, 1);

  FaceId face(std::uint32_t record) const { return found_.segments[record].on[other(s_)].face(); }
  HalfEdgeId half_edge(std::uint32_t record) const {
    return Brep::half_edge(found_.segments[record].on[s_].edge());
  }
  PointId end(std::uint32_t record, int which) const {
    return found_.point(found_.segments[record].place[which]);
  }
  // A plane through the segment across the face.
  PlaneId across(std::uint32_t record) const {
    const auto [a, b] = line_planes(w_.patch[s_], half_edge(record));
    return kernel_.parallel(w_.patch[other(s_)].plane(face(record)), a) ? b : a;
  }
  bool have_common_end(std::uint32_t i, std::uint32_t j) const {
    for (const PlaceId p : found_.segments[i].place)
      for (const PlaceId q : found_.segments[j].place)
        if (p == q) return true;
    return false;
  }
  bool is_crossed(std::uint32_t record, PlaneId plane) const {
    return kernel_.side(end(record, 0), plane) * kernel_.side(end(record, 1), plane) ==
           Sign::negative;
  }

  void cross(std::uint32_t i, std::uint32_t j, std::vector<Crossing>& out) const {
    if (have_common_end(i, j) || !is_crossed(i, across(j)) || !is_crossed(j, across(i))) return;
    out.push_back({{i, j}, edge_plane_construction(w_, s_, half_edge(i), across(j))});
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& found_;
  Operand s_;
  std::vector<std::uint32_t> order_;  // by face
  std::vector<std::span<const std::uint32_t>> groups_;
};

void add_contacts(Workspace& w, const std::vector<Crossing>& crossings, Contacts& found) {
  const ContactId first = found.contacts.end_id();
  for (const Crossing& crossing : crossings) {
    const PointId point =
        add_constructed(w.geometry, crossing.how, w.tests().construct(crossing.how));
    for (const std::uint32_t record : crossing.record) {
      Contact contact;
      for (const Operand s : both_operands) contact.on[s] = found.segments[record].on[s];
      contact.point = point;
      found.contacts.add(contact);
    }
  }
  w.kernel->refresh();
  find_places(w, first, found);
}

}  // namespace

bool add_crossings(Workspace& w, Contacts& found) {
  std::vector<Crossing> crossings;
  for (const Operand s : both_operands) {
    const CrossingEdges edges(w, found, s);
    using Crossings = std::vector<Crossing>;
    append(crossings,
           joined(collect<Crossings>(w, edges.groups(), 32,
                                     [&](std::size_t i, Crossings& out) { edges(i, out); })));
  }
  if (crossings.empty()) return false;
  add_contacts(w, crossings, found);
  return true;
}

}  // namespace sectile
