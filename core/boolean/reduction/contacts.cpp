// Steps (1) to (8) of section 5 of the paper: each edge and vertex of one solid against each face
// of the other that comes near it, once.
#include <algorithm>
#include <iterator>
#include <numeric>

#include "boolean/collect.h"
#include "boolean/face_location.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "search/large_sort.h"

namespace sectile {
namespace {

// The half-edges of a loop or face whose boxes meet a box, or all of a small face.
bool near_half_edges(const Patch& patch, FaceId face, const Box& box,
                     std::vector<SidedHalfEdge>& out) {
  if (const BoxTree* tree = patch.half_edge_tree[face.value()].get()) {
    tree->query([&](const Box& b) { return b.overlaps(box); },
                [&](std::uint32_t item) {
                  out.push_back({patch.tree_half_edges[face.value()][item], {}, {}});
                });
    return false;
  }
  for_each_in_face(patch.brep, face, [&](HalfEdgeId h) { out.push_back({h, {}, {}}); });
  return true;
}

// The half-edges of a face that come near another one, with their sides. Returns false if it is
// certain that the face does not reach the plane.
bool sided_half_edges(const Workspace& w, int solid, FaceId face, FaceId other,
                      std::vector<SidedHalfEdge>& out) {
  const Patch& patch = w.patch[solid];
  if (patch.unbounded) return true;
  const Patch& others = w.patch[1 - solid];
  const PlaneId plane = others.plane(other);
  const auto side = [&](VertexId v) { return w.tests().side(patch.brep.point_of(v), plane); };
  const Box near = others.unbounded ? Box::everything() : others.face_boxes[other.value()];
  if (!near_half_edges(patch, face, near, out)) {
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
  std::vector<Hit> hits[2];
  std::vector<InPlane> in_plane[2];
  std::vector<std::pair<EdgeId, EdgeId>> flat_crossings;
  std::vector<PairOfFaces> pairs;
  std::vector<SidedHalfEdge> meeting[2];
  std::vector<SidedHalfEdge> sided[2];  // scratch
  std::vector<HalfEdgeId> flat[2];      // scratch
  std::vector<Entity> found;            // scratch
};

class PairTest {
  // So many are tested one by one.
  static constexpr std::size_t few_pairs = 256;

 public:
  PairTest(const Workspace& w, PairOutput& out) : w_(w), kernel_(w.tests()), out_(out) {}

  void operator()(FaceId a, FaceId b) {
    auto& sided = out_.sided;
    sided[0].clear();
    sided[1].clear();
    if (!sided_half_edges(w_, 0, a, b, sided[0]) || !sided_half_edges(w_, 1, b, a, sided[1]))
      return;
    const bool coplanar = kernel_.coplanar(w_.patch[0].plane(a), w_.patch[1].plane(b));
    add_pair(a, b, coplanar);
    pierce(0, a, b);
    pierce(1, b, a);
    if (coplanar) cross_flat_edges(a, b);
  }

 private:
  void add_pair(FaceId a, FaceId b, bool coplanar) {
    PairOfFaces pair{{a, b}, coplanar, {}, {}};
    for (int s = 0; s < 2; ++s) {
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
  void pierce(int s, FaceId face, FaceId other) {
    const Patch& patch = w_.patch[s];
    for (const SidedHalfEdge& i : out_.sided[s]) {
      const VertexId v = patch.brep.from(i.h);
      if (i.from == Sign::zero && patch.owner(v) == face &&
          patch.brep.vertex_half_edge[v.value()] == i.h)
        record(s, v, other, Probe(kernel_, patch.brep.point_of(v)));
      const EdgeId e = Brep::edge_of(i.h);
      if (patch.owner(e) != face) continue;
      if (i.from * i.to == Sign::negative)
        record(s, e, other, edge_probe(s, i.h, other));
      else if (i.from == Sign::zero && i.to == Sign::zero)
        out_.in_plane[s].push_back({e, other});
    }
  }

  Probe edge_probe(int s, HalfEdgeId h, FaceId other) const {
    const Brep& brep = w_.patch[s].brep;
    return Probe(kernel_, brep.point_of(brep.from(h)), brep.point_of(brep.to(h)),
                 edge_plane_construction(w_, s, h, w_.patch[1 - s].plane(other)));
  }

  void record(int s, Entity piercer, FaceId other, const Probe& probe) {
    locate(kernel_, w_.patch[1 - s], other, probe, out_.found);
    for (const Entity found : out_.found) out_.hits[s].push_back({piercer, other, found});
  }

  // Two edges between coplanar faces in one plane: no face is crossed there, so the edges are
  // tested against each other.
  void cross_flat_edges(FaceId a, FaceId b) {
    collect_flat(0, a);
    collect_flat(1, b);
    const auto& [of_a, of_b] = out_.flat;
    if (of_a.size() * of_b.size() <= few_pairs) {
      for (const HalfEdgeId h : of_a)
        for (const HalfEdgeId i : of_b) cross_flat(h, i);
    } else {
      BoxTree::overlaps(box_tree(0), box_tree(1), [&](std::uint32_t i, std::uint32_t j) {
        cross_flat(out_.flat[0][i], out_.flat[1][j]);
      });
    }
  }

  // The flat edges that the face speaks for.
  void collect_flat(int s, FaceId face) {
    const Patch& patch = w_.patch[s];
    out_.flat[s].clear();
    for (const SidedHalfEdge& i : out_.sided[s])
      if (const EdgeId e = Brep::edge_of(i.h); patch.is_flat(e) && patch.owner(e) == face)
        out_.flat[s].push_back(i.h);
  }

  BoxTree box_tree(int s) const {
    const Brep& brep = w_.patch[s].brep;
    std::vector<Box> boxes;
    boxes.reserve(out_.flat[s].size());
    for (const HalfEdgeId h : out_.flat[s]) {
      Bounds bounds;
      for (const VertexId v : {brep.from(h), brep.to(h)})
        bounds.add(w_.geometry.position(brep.point_of(v)));
      boxes.push_back(bounds.box());
    }
    return BoxTree(boxes);
  }

  void cross_flat(HalfEdgeId h, HalfEdgeId i) {
    if (ends_apart(0, h, w_.patch[1].side(i)) && ends_apart(1, i, w_.patch[0].side(h)))
      out_.flat_crossings.push_back({Brep::edge_of(h), Brep::edge_of(i)});
  }

  bool ends_apart(int s, HalfEdgeId h, PlaneId plane) const {
    const Brep& brep = w_.patch[s].brep;
    return kernel_.side(brep.point_of(brep.from(h)), plane) *
               kernel_.side(brep.point_of(brep.to(h)), plane) ==
           Sign::negative;
  }

  const Workspace& w_;
  const Kernel& kernel_;
  PairOutput& out_;
};

// The plane through edge h of solid s that cuts the line of an edge of the other solid.
PlaneId cutting_plane(const Workspace& w, int s, EdgeId e, PlaneId a, PlaneId b) {
  const Patch& patch = w.patch[s];
  for (unsigned side = 0; side < 2; ++side) {
    const PlaneId plane = patch.side(Brep::half_edge(e, side));
    if (plane.valid() && w.tests().det(a, b, plane) != Sign::zero) return plane;
  }
  return line_planes(patch, Brep::half_edge(e)).first;
}

Construction contact_construction(const Workspace& w, const Contact& contact) {
  for (int s = 0; s < 2; ++s) {
    if (!contact.on[s].is_edge()) continue;
    const HalfEdgeId h = Brep::half_edge(contact.on[s].edge());
    const Entity other = contact.on[1 - s];
    if (other.is_face())
      return edge_plane_construction(w, s, h, w.patch[1 - s].plane(other.face()));
    const auto [a, b] = line_planes(w.patch[s], h);
    return edge_plane_construction(w, s, h, cutting_plane(w, 1 - s, other.edge(), a, b));
  }
  return {};
}

void make_points(Workspace& w) {
  struct Made {
    Construction how;
    ConstructedPoint point;
  };
  std::vector<Made> made(w.contacts.size());
  collect<int>(w, w.contacts.size(), 64, [&](std::size_t i, int&) {
    Contact& c = w.contacts[i];
    PointId known;
    for (int s = 0; s < 2; ++s) {
      if (!c.on[s].is_vertex()) continue;
      const PointId p = w.patch[s].brep.point_of(c.on[s].vertex());
      if (!known.valid() || !w.geometry.is_constructed(p)) known = p;
    }
    c.point = known;
    if (known.valid()) return;
    made[i].how = contact_construction(w, c);
    made[i].point = w.tests().construct(made[i].how);
  });
  for (std::size_t i = 0; i < made.size(); ++i)
    if (!w.contacts[i].point.valid())
      w.contacts[i].point = add_constructed(w.geometry, made[i].how, made[i].point);
  w.kernel->refresh();
}

void number_contacts(Workspace& w, ContactTable& table) {
  const auto by_entities = [](const Contact& c) {
    return std::uint64_t(c.on[0].code()) << 32 | c.on[1].code();
  };
  const auto contact_of = [](int s, const Hit& hit) {
    Contact c;
    c.on[s] = hit.piercer;
    c.on[1 - s] = hit.found;
    return c;
  };
  for (int s = 0; s < 2; ++s)
    for (const Hit& hit : table.hits[s]) w.contacts.push_back(contact_of(s, hit));
  for (const auto& [e, f] : table.flat_crossings) {
    Contact c;
    c.on[0] = e;
    c.on[1] = f;
    w.contacts.push_back(c);
  }
  large_sort(w.contacts,
             [&](const Contact& p, const Contact& q) { return by_entities(p) < by_entities(q); });
  w.contacts.erase(std::unique(w.contacts.begin(), w.contacts.end(),
                               [&](const Contact& p, const Contact& q) {
                                 return by_entities(p) == by_entities(q);
                               }),
                   w.contacts.end());
  for (int s = 0; s < 2; ++s) {
    std::vector<Hit>& hits = table.hits[s];
    large_sort(hits, [](const Hit& p, const Hit& q) {
      return p.key() != q.key() ? p.key() < q.key() : p.found.code() < q.found.code();
    });
    collect<int>(w, hits.size(), 1024, [&](std::size_t i, int&) {
      const std::uint64_t key = by_entities(contact_of(s, hits[i]));
      const auto at = std::lower_bound(
          w.contacts.begin(), w.contacts.end(), key,
          [&](const Contact& c, std::uint64_t wanted) { return by_entities(c) < wanted; });
      hits[i].contact = static_cast<std::uint32_t>(at - w.contacts.begin());
    });
    table.hits_of[s] = HitsOfPiercers(hits, w.patch[s].brep);
  }
}

}  // namespace

HitsOfPiercers::HitsOfPiercers(std::span<const Hit> hits, const Brep& brep)
    : vertices_(brep.vertex_count()), first_(brep.vertex_count() + brep.edge_count() + 1, 0) {
  // Vertices come before edges in the order of the keys, too.
  for (const Hit& hit : hits) {
    const Entity p = hit.piercer;
    ++first_[(p.is_edge() ? p.index() + vertices_ : p.index()) + 1];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
}

std::span<const Hit> ContactTable::find(int solid, Entity piercer, FaceId face) const {
  const auto [first, last] = hits_of[solid][piercer];
  const std::span<const Hit> of_piercer = std::span(hits[solid]).subspan(first, last - first);
  const auto [from, to] =
      std::equal_range(of_piercer.begin(), of_piercer.end(), Hit{piercer, face, {}, 0},
                       [](const Hit& p, const Hit& q) { return p.face < q.face; });
  return {from, to};
}

ContactTable find_contacts(Workspace& w, const FacePairs& candidates) {
  auto outputs =
      collect<PairOutput>(w, candidates.size(), 128, [&](std::size_t i, PairOutput& out) {
        PairTest(w, out)(candidates[i].first, candidates[i].second);
      });
  ContactTable table;
  for (PairOutput& out : outputs) {
    for (int s = 0; s < 2; ++s) {
      for (PairOfFaces& pair : out.pairs)
        for (auto* bound : {pair.first_sided, pair.last_sided})
          bound[s] += static_cast<std::uint32_t>(table.sided[s].size());
      append(table.sided[s], out.meeting[s]);
      append(table.hits[s], out.hits[s]);
      append(table.in_plane[s], out.in_plane[s]);
    }
    append(table.flat_crossings, out.flat_crossings);
    append(table.pairs, out.pairs);
  }
  number_contacts(w, table);
  make_points(w);
  find_places(w, 0);
  return table;
}

}  // namespace sectile
