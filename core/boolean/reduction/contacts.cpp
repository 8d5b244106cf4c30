// Steps (1) to (8) of section 5 of the paper: each edge and vertex of one solid against each face
// of the other that comes near it, once.
#include <algorithm>
#include <iterator>
#include <numeric>
#include <tuple>

#include "boolean/collect.h"
#include "boolean/face_location.h"
#include "boolean/line.h"
#include "boolean/reduction/common_border.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/near_half_edges.h"
#include "boolean/reduction/tests_on_lines.h"
#include "geometry/constructed_points.h"
#include "numbers/threshold.h"
#include "search/bucket_sort.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

// The half-edges of a face that come near another one, with their sides. Returns false if it is
// certain that the face does not reach the plane.
bool sided_half_edges(const Workspace& w, Operand solid, FaceId face, FaceId across,
                      std::vector<SidedHalfEdge>& out) {
  const Patch& patch = w.patch[solid];
  if (patch.unbounded) return true;
  const PlaneId plane = w.patch[other(solid)].plane(across);
  const auto side = [&](VertexId v) { return w.tests().side(patch.brep.point_of(v), plane); };
  if (!near_half_edges(w, solid, face, across, out)) {
    for (SidedHalfEdge& i : out) {
      i.from = side(patch.brep.from(i.h));
      i.to = side(patch.brep.to(i.h));
    }
    return true;
  }
  bool positive = false, negative = false, zero = false;
  for (SidedHalfEdge& i : out) {
    i.from = side(patch.brep.from(i.h));
    (i.from == Sign::zero ? zero : i.from == Sign::positive ? positive : negative) = true;
  }
  // Loop by loop, each half-edge ends where the next begins.
  for (std::size_t i = 0, first = 0; i < out.size(); ++i) {
    const bool closes =
        i + 1 == out.size() || patch.brep.loop_of(out[i].h) != patch.brep.loop_of(out[i + 1].h);
    out[i].to = closes ? out[first].from : out[i + 1].from;
    if (closes) first = i + 1;
  }
  return zero || (positive && negative);
}

struct PairOutput {
  PerOperand<UnsetVector<Hit>> hits;
  PerOperand<UnsetVector<InPlane>> in_plane;
  std::vector<std::pair<EdgeId, EdgeId>> flat_crossings;
  UnsetVector<PairOfFaces> pairs;
  PerOperand<UnsetVector<SidedHalfEdge>> meeting;
  PerOperand<std::vector<SidedHalfEdge>> sided;  // scratch
  PerOperand<std::vector<HalfEdgeId>> flat;      // scratch
  std::vector<Entity> found;                     // scratch

  // For so many pairs of convex faces that cross each other.
  void reserve(std::size_t count) {
    pairs.reserve(count);
    for (const Operand s : both_operands) {
      hits[s].reserve(count);
      meeting[s].reserve(2 * count);
    }
  }
};

class PairTest {
  // So many are tested one by one.
  static constexpr std::size_t few_pairs = threshold(256, 1);

 public:
  PairTest(const Workspace& w, const TestsOnLines& on_lines, PairOutput& out)
      : w_(w), kernel_(w.tests()), on_lines_(on_lines), out_(out) {}

  void operator()(std::size_t pair, FaceId a, FaceId b) {
    pair_ = pair;
    auto& sided = out_.sided;
    sided[Operand::a].clear();
    sided[Operand::b].clear();
    if (!sided_half_edges(w_, Operand::a, a, b, sided[Operand::a]) ||
        !sided_half_edges(w_, Operand::b, b, a, sided[Operand::b]))
      return;
    if (const auto border = only_common_border(w_, sided)) return record(*border);
    const bool coplanar =
        kernel_.coplanar(w_.patch[Operand::a].plane(a), w_.patch[Operand::b].plane(b));
    add_pair(a, b, coplanar);
    pierce(Operand::a, a, b);
    pierce(Operand::b, b, a);
    if (coplanar) cross_flat_edges(a, b);
  }

 private:
  // The segment in a common edge is found as that of edges.
  void record(const CommonBorder& border) {
    for (const Operand s : both_operands) {
      const Brep &brep = w_.patch[s].brep, &across = w_.patch[other(s)].brep;
      const FaceId beyond = across.face_of(border.corner[0][other(s)]);
      for (std::size_t i = 0; i < border.corners; ++i) {
        const HalfEdgeId h = border.corner[i][s];
        if (speaks_for_vertex(s, brep.face_of(h), h))
          out_.hits[s].push_back(
              {tested_vertex(s, h), beyond, across.from(border.corner[i][other(s)]), {}});
      }
      if (const HalfEdgeId h = border.edge[s]; h.valid() && speaks_for_edge(s, brep.face_of(h), h))
        out_.in_plane[s].push_back({Brep::edge_of(h), beyond});
    }
  }

  void add_pair(FaceId a, FaceId b, bool coplanar) {
    PairOfFaces pair{{a, b}, coplanar, {}, {}};
    for (const Operand s : both_operands) {
      auto& meeting = out_.meeting[s];
      pair.first_sided[s] = static_cast<std::uint32_t>(meeting.size());
      if (!coplanar)
        std::copy_if(out_.sided[s].begin(), out_.sided[s].end(), std::back_inserter(meeting),
                     [](const SidedHalfEdge& i) { return i.meets_plane(); });
      pair.last_sided[s] = static_cast<std::uint32_t>(meeting.size());
    }
    out_.pairs.push_back(pair);
  }

  // Edges and vertices that this face of solid s speaks for, against the other face.
  void pierce(Operand s, FaceId face, FaceId across) {
    const Patch& patch = w_.patch[s];
    for (const SidedHalfEdge& i : out_.sided[s]) {
      if (i.from == Sign::zero && speaks_for_vertex(s, face, i.h))
        record(s, tested_vertex(s, i.h), across,
               Probe(kernel_, patch.brep.point_of(patch.brep.from(i.h))));
      const EdgeId e = Brep::edge_of(i.h);
      if (!speaks_for_edge(s, face, i.h)) continue;
      if (i.from * i.to == Sign::negative)
        record(s, e, across, edge_probe(s, i.h, across));
      else if (i.from == Sign::zero && i.to == Sign::zero)
        out_.in_plane[s].push_back({e, across});
    }
  }

  bool speaks_for_vertex(Operand s, FaceId face, HalfEdgeId h) const {
    const Patch& patch = w_.patch[s];
    const VertexId v = patch.brep.from(h);
    if (on_lines_.has_vertex(s, v)) return on_lines_.vertex_is_tested(s, pair_, h);
    return patch.owner(v) == face && patch.brep.vertex_half_edge[v] == h;
  }
  // The start of a half-edge that speaks for it. On lines, it may do so for many in one place.
  VertexId tested_vertex(Operand s, HalfEdgeId h) const {
    const Patch& patch = w_.patch[s];
    const VertexId v = patch.brep.from(h);
    return on_lines_.has_vertex(s, v) ? patch.tested(v) : v;
  }
  bool speaks_for_edge(Operand s, FaceId face, HalfEdgeId h) const {
    if (on_lines_.has_edge(s, h)) return on_lines_.edge_is_tested(s, pair_, h);
    return w_.patch[s].owner(Brep::edge_of(h)) == face;
  }

  Probe edge_probe(Operand s, HalfEdgeId h, FaceId across) const {
    const Brep& brep = w_.patch[s].brep;
    return Probe(kernel_, brep.point_of(brep.from(h)), brep.point_of(brep.to(h)),
                 edge_plane_construction(w_, s, h, w_.patch[other(s)].plane(across)));
  }

  void record(Operand s, Entity piercer, FaceId across, const Probe& probe) {
    locate(kernel_, w_.patch[other(s)], across, probe, out_.found);
    for (const Entity found : out_.found) out_.hits[s].push_back({piercer, across, found, {}});
  }

  // Two edges between coplanar faces in one plane: no face is crossed there, so the edges are
  // tested against each other.
  void cross_flat_edges(FaceId a, FaceId b) {
    collect_flat(Operand::a, a);
    collect_flat(Operand::b, b);
    const auto &of_a = out_.flat[Operand::a], &of_b = out_.flat[Operand::b];
    if (of_a.size() * of_b.size() <= few_pairs) {
      for (const HalfEdgeId h : of_a)
        for (const HalfEdgeId i : of_b) cross_flat(h, i);
    } else {
      PieceTree::overlaps(tree_of_flat(Operand::a), tree_of_flat(Operand::b),
                          [&](std::uint32_t i, std::uint32_t j) {
                            cross_flat(out_.flat[Operand::a][i], out_.flat[Operand::b][j]);
                          });
    }
  }

  // The flat edges that the face speaks for.
  void collect_flat(Operand s, FaceId face) {
    const Patch& patch = w_.patch[s];
    out_.flat[s].clear();
    for (const SidedHalfEdge& i : out_.sided[s])
      if (const EdgeId e = Brep::edge_of(i.h); patch.is_flat(e) && speaks_for_edge(s, face, i.h))
        out_.flat[s].push_back(i.h);
  }

  PieceTree tree_of_flat(Operand s) const {
    const Brep& brep = w_.patch[s].brep;
    std::vector<PieceTree::Edge> edges;
    edges.reserve(out_.flat[s].size());
    for (const HalfEdgeId h : out_.flat[s])
      edges.push_back({w_.geometry.position(brep.point_of(brep.from(h))),
                       w_.geometry.position(brep.point_of(brep.to(h)))});
    return PieceTree(edges);
  }

  void cross_flat(HalfEdgeId h, HalfEdgeId i) {
    if (ends_apart(Operand::a, h, w_.patch[Operand::b].side(i)) &&
        ends_apart(Operand::b, i, w_.patch[Operand::a].side(h)))
      out_.flat_crossings.push_back({Brep::edge_of(h), Brep::edge_of(i)});
  }

  bool ends_apart(Operand s, HalfEdgeId h, PlaneId plane) const {
    const Brep& brep = w_.patch[s].brep;
    return kernel_.side(brep.point_of(brep.from(h)), plane) *
               kernel_.side(brep.point_of(brep.to(h)), plane) ==
           Sign::negative;
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const TestsOnLines& on_lines_;
  std::size_t pair_ = 0;  // that is tested
  PairOutput& out_;
};

// The plane through edge h of solid s that cuts the line of an edge of the other solid.
PlaneId cutting_plane(const Workspace& w, Operand s, EdgeId e, PlaneId a, PlaneId b) {
  const Patch& patch = w.patch[s];
  for (unsigned side = 0; side < 2; ++side) {
    const PlaneId plane = patch.side(Brep::half_edge(e, side));
    if (plane.valid() && w.tests().det(a, b, plane) != Sign::zero) return plane;
  }
  return line_planes(patch, Brep::half_edge(e)).first;
}

Construction contact_construction(const Workspace& w, const Contact& contact) {
  for (const Operand s : both_operands) {
    if (!contact.on[s].is_edge()) continue;
    const HalfEdgeId h = Brep::half_edge(contact.on[s].edge());
    const Entity across = contact.on[other(s)];
    if (across.is_face())
      return edge_plane_construction(w, s, h, w.patch[other(s)].plane(across.face()));
    const auto [a, b] = line_planes(w.patch[s], h);
    return edge_plane_construction(w, s, h, cutting_plane(w, other(s), across.edge(), a, b));
  }
  return {};
}

void make_points(Workspace& w, Table<ContactId, Contact>& contacts) {
  Table<ContactId, MadePoint> made;  // of those that have no point yet
  made.resize_unwritten(contacts.size());
  for_each(w, contacts.size(), 64, [&](std::size_t i) {
    const ContactId id(i);
    Contact& c = contacts[id];
    PointId known;
    for (const Operand s : both_operands) {
      if (!c.on[s].is_vertex()) continue;
      const PointId p = w.patch[s].brep.point_of(c.on[s].vertex());
      if (!known.valid() || !w.geometry.is_constructed(p)) known = p;
    }
    c.point = known;
    if (known.valid()) return;
    made[id].how = contact_construction(w, c);
    made[id].point = w.tests().construct(made[id].how);
  });
  add_constructed_points(
      w.geometry, contacts.size(),
      [&](std::size_t i) {
        const ContactId id(i);
        return contacts[id].point.valid() ? nullptr : &std::as_const(made)[id];
      },
      [&](std::size_t i, PointId point) { contacts[ContactId(i)].point = point; });
  w.kernel->refresh();
}

// The entities of a contact as some pair of faces found them; `order` counts what is found.
struct Found {
  Entity a, b;
  std::uint32_t order;
};

// Contacts are numbered as pairs of faces find them first: what is near in the solids is near in
// all tables from here on, and so in the caches. What lies within a face is found by one pair only.
class Numbering {
 public:
  Numbering(const EntityNumbers& of_a, std::vector<PairOutput>& outputs)
      : of_a_(of_a), outputs_(outputs), begins_(outputs.size() + 1), found_before_(begins_) {}

  Table<ContactId, Contact> run() {
    find_first_finds();
    number_first_finds();
    if (!first_.empty()) number_others();
    return std::move(contacts_);
  }

 private:
  static bool is_found_once(Entity a, Entity b) { return a.is_face() || b.is_face(); }

  // Calls visit(entity of A, entity of B, the contact's number) for what the pairs of an output
  // found, one after the other.
  template <class Visit>
  static void for_each_found(PairOutput& out, const Visit& visit) {
    ContactId of_crossing;
    for (Hit& hit : out.hits[Operand::a]) visit(hit.piercer, hit.found, hit.contact);
    for (Hit& hit : out.hits[Operand::b]) visit(hit.found, hit.piercer, hit.contact);
    for (const auto& [e, f] : out.flat_crossings) visit(e, f, of_crossing);
  }
  template <class Body>
  void for_each_output(const Body& body) {
    constexpr std::size_t few = threshold(16, 1);
    parallel::loop(parallel::Range<std::size_t>(0, outputs_.size(), few), [&](const auto& some) {
      for (std::size_t i = some.begin(); i < some.end(); ++i) body(i);
    });
  }
  static void add_up(std::vector<std::uint32_t>& counts) {
    std::exclusive_scan(counts.begin(), counts.end(), counts.begin(), 0u);
  }

  void find_first_finds() {
    for_each_output([&](std::size_t i) {
      for_each_found(outputs_[i], [&](Entity a, Entity b, ContactId&) {
        ++(is_found_once(a, b) ? begins_ : found_before_)[i];
      });
    });
    add_up(found_before_);
    if (found_before_.back() == 0) return;
    UnsetVector<Found> found(found_before_.back());
    for_each_output([&](std::size_t i) {
      std::uint32_t next = found_before_[i];
      for_each_found(outputs_[i], [&](Entity a, Entity b, ContactId&) {
        if (!is_found_once(a, b)) found[next] = {a, b, next}, ++next;
      });
    });
    bucket_sort(
        found, of_a_.size(), [&](const Found& f) { return of_a_[f.a]; },
        [](const Found& p, const Found& q) {
          return std::tie(p.b, p.order) < std::tie(q.b, q.order);
        });
    first_.resize(found.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      const bool again = i > 0 && found[i].a == found[i - 1].a && found[i].b == found[i - 1].b;
      first_[found[i].order] = again ? first_[found[i - 1].order] : found[i].order;
    }
    number_.resize(found.size());
  }

  void number_first_finds() {
    const auto for_each_new = [&](std::size_t i, const auto& visit) {
      std::uint32_t next = found_before_[i];
      for_each_found(outputs_[i], [&](Entity a, Entity b, ContactId& number) {
        if (is_found_once(a, b)) return visit(a, b, number);
        if (first_[next] == next) visit(a, b, number_[next]);
        ++next;
      });
    };
    add_first_finds();
    add_up(begins_);
    contacts_.resize_unwritten(begins_.back());
    for_each_output([&](std::size_t i) {
      ContactId next(begins_[i]);
      for_each_new(i, [&](Entity a, Entity b, ContactId& number) {
        contacts_[next] = {{a, b}, {}, {}};
        number = next;
        next = ContactId(next.value() + 1);
      });
    });
  }

  // To what is found once, in each output.
  void add_first_finds() {
    if (first_.empty()) return;
    for (std::size_t i = 0; i < outputs_.size(); ++i)
      for (std::uint32_t f = found_before_[i]; f < found_before_[i + 1]; ++f)
        begins_[i] += first_[f] == f ? 1 : 0;
  }

  void number_others() {
    for_each_output([&](std::size_t i) {
      std::uint32_t next = found_before_[i];
      for_each_found(outputs_[i], [&](Entity a, Entity b, ContactId& number) {
        if (!is_found_once(a, b)) number = number_[first_[next++]];
      });
    });
  }

  const EntityNumbers& of_a_;
  std::vector<PairOutput>& outputs_;
  std::vector<std::uint32_t> begins_, found_before_;  // per output, and the end
  // Of what several pairs may find, per element: the first one with the same entities, its number.
  UnsetVector<std::uint32_t> first_;
  UnsetVector<ContactId> number_;
  Table<ContactId, Contact> contacts_;
};

// What the pairs found, in one; [s] as in the table.
void join(std::vector<PairOutput>& outputs, ContactTable& table) {
  for (const Operand s : both_operands) {
    const auto meeting = [s](auto& out) -> auto& {
      return out.meeting[s];
    };
    const std::vector<std::uint32_t> begin = begins_of(outputs, meeting);
    for (std::size_t i = 0; i < outputs.size(); ++i)
      for (PairOfFaces& pair : outputs[i].pairs) {
        pair.first_sided[s] += begin[i];
        pair.last_sided[s] += begin[i];
      }
    table.sided[s] = joined<UnsetVector<SidedHalfEdge>>(outputs, meeting);
    table.hits[s] = joined<UnsetVector<Hit>>(
        outputs, [s](auto& out) -> auto& { return out.hits[s]; });
    table.in_plane[s] = joined<UnsetVector<InPlane>>(
        outputs, [s](auto& out) -> auto& { return out.in_plane[s]; });
  }
  table.pairs = joined<UnsetVector<PairOfFaces>>(
      outputs, [](auto& out) -> auto& { return out.pairs; });
}

void sort_by_piercer(ContactTable& table) {
  for (const Operand s : both_operands)
    table.first_hit[s] = bucket_sort(
        table.hits[s], table.numbers[s].size(),
        [&](const Hit& hit) { return table.numbers[s][hit.piercer]; },
        [](const Hit& p, const Hit& q) {
          return std::tie(p.face, p.found) < std::tie(q.face, q.found);
        });
}

}  // namespace

std::span<const Hit> ContactTable::find(Operand solid, Entity piercer, FaceId face) const {
  const std::size_t number = numbers[solid][piercer];
  const std::uint32_t first = first_hit[solid][number], last = first_hit[solid][number + 1];
  const std::span<const Hit> of_piercer = std::span(hits[solid]).subspan(first, last - first);
  const auto [from, to] =
      std::equal_range(of_piercer.begin(), of_piercer.end(), Hit{piercer, face, {}, {}},
                       [](const Hit& p, const Hit& q) { return p.face < q.face; });
  return {from, to};
}

ContactTable find_contacts(Workspace& w, const FacePairs& candidates, Contacts& found) {
  const TestsOnLines on_lines(w, candidates);
  auto outputs = collect_ranges<PairOutput>(
      w, candidates.size(), 128, [&](std::size_t first, std::size_t last, PairOutput& out) {
        out.reserve(last - first);
        PairTest test(w, on_lines, out);
        for (std::size_t i = first; i < last; ++i)
          test(i, candidates[i].first, candidates[i].second);
      });
  ContactTable table;
  for (const Operand s : both_operands) table.numbers[s] = EntityNumbers(w.patch[s].brep);
  found.contacts = Numbering(table.numbers[Operand::a], outputs).run();
  join(outputs, table);
  sort_by_piercer(table);
  make_points(w, found.contacts);
  find_places(w, ContactId(0), found);
  return table;
}

}  // namespace sectile
