#include "boolean/reduction/rows_on_lines.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include "boolean/reduction/edges_on_lines.h"
#include "search/bucket_sort.h"
#include "search/edges_by_line.h"

namespace sectile {
namespace {

// Where something of the other operand meets an edge.
struct Met {
  EdgeId edge;
  PlaceId place;
  friend auto operator<=>(const Met&, const Met&) = default;
};

// What the contacts and segments say of one operand.
class MetOnEdges {
 public:
  MetOnEdges(const Workspace& w, const Contacts& found, Operand s)
      : in_face_(w.patch[s].brep.edge_count(), 0), place_of_(w.patch[s].brep.vertex_count()) {
    for (const SegmentRecord& r : found.segments)
      if (r.on[s].is_edge() && r.on[other(s)].is_face()) in_face_[r.on[s].edge()] = 1;
    for (const Contact& c : found.contacts) {
      if (c.on[s].is_edge()) met_.push_back({c.on[s].edge(), c.place});
      if (c.on[s].is_vertex()) place_of_[c.on[s].vertex()] = c.place;
    }
    first_ = bucket_sort(
        met_, in_face_.size(), [](const Met& m) { return m.edge.value(); }, std::less<>());
  }

  bool is_in_face(EdgeId e) const { return in_face_[e] != 0; }
  /// Invalid if the vertex meets nothing.
  PlaceId place_of(VertexId v) const { return place_of_[v]; }
  std::span<const Met> at(EdgeId e) const {
    return std::span(met_).subspan(first_[e.value()], first_[e.value() + 1] - first_[e.value()]);
  }

 private:
  Table<EdgeId, std::uint8_t> in_face_;
  Table<VertexId, PlaceId> place_of_;
  std::vector<Met> met_;              // by edge
  std::vector<std::uint32_t> first_;  // per edge, and the end
};

struct EdgeOfOperand {
  Operand operand;
  EdgeId edge;
};

// The row of one line.
class RowMaker {
 public:
  RowMaker(Workspace& w, Contacts& found, const PerOperand<MetOnEdges>& met,
           const std::array<PointId, 2>& line)
      : w_(w), found_(found), met_(met) {
    for (axis_ = 0; axis_ < 2 && w.tests().compare(line[0], line[1], axis_) == Sign::zero;) ++axis_;
  }

  Row run(std::span<const EdgeOfOperand> edges) {
    for (const EdgeOfOperand& e : edges) add_nodes(e);
    sort_nodes();
    for (const EdgeOfOperand& e : edges) add_run(e);
    return std::move(row_);
  }

 private:
  // A vertex at an end of an edge, or where something meets one.
  struct Node {
    PointId point;
    PlaceId place;  // invalid if it meets nothing
    Operand operand;
    VertexId vertex;  // of the operand, at an end
  };

  const Brep& brep(Operand s) const { return w_.patch[s].brep; }

  void add_nodes(const EdgeOfOperand& e) {
    const HalfEdgeId h = Brep::half_edge(e.edge);
    for (const VertexId v : {brep(e.operand).from(h), brep(e.operand).to(h)})
      nodes_.push_back({brep(e.operand).point_of(v), met_[e.operand].place_of(v), e.operand, v});
    for (const Met& met : met_[e.operand].at(e.edge))
      nodes_.push_back({found_.point(met.place), met.place, e.operand, {}});
  }

  // Those at one point become one place of the row, and of the contacts.
  void sort_nodes() {
    std::ranges::sort(nodes_, [&](const Node& p, const Node& q) {
      const Sign sign = compare(p.point, q.point);
      return sign != Sign::zero ? sign == Sign::positive
                                : p.place.valid() && (!q.place.valid() || p.place < q.place);
    });
    for (std::size_t from = 0, to; from < nodes_.size(); from = to) {
      for (to = from + 1;
           to < nodes_.size() && compare(nodes_[from].point, nodes_[to].point) == Sign::zero;)
        ++to;
      add_place(std::span(nodes_).subspan(from, to - from));
    }
  }
  Sign compare(PointId p, PointId q) const {
    return p == q ? Sign::zero : w_.tests().compare(p, q, axis_);
  }

  void add_place(std::span<const Node> nodes) {
    PlaceId place = nodes.front().place;
    if (!place.valid()) place = found_.places.add(nodes.front().point);
    for (const Node& node : nodes)
      if (node.vertex.valid()) w_.patch[node.operand].brep.point[node.vertex] = found_.point(place);
    row_.places.push_back(place);
  }

  std::uint32_t number(PointId point) const {
    const auto at = std::ranges::partition_point(row_.places, [&](PlaceId place) {
      return compare(found_.point(place), point) == Sign::positive;
    });
    return static_cast<std::uint32_t>(at - row_.places.begin());
  }

  void add_run(const EdgeOfOperand& e) {
    const HalfEdgeId h = Brep::half_edge(e.edge);
    const VertexId from = brep(e.operand).from(h), to = brep(e.operand).to(h);
    Row::Run run{e.operand,
                 e.edge,
                 number(brep(e.operand).point_of(from)),
                 number(brep(e.operand).point_of(to)),
                 {from, to}};
    if (run.from > run.to) {
      std::swap(run.from, run.to);
      std::swap(run.end[0], run.end[1]);
    }
    const auto index = static_cast<std::uint32_t>(row_.runs.size());
    for (const Met& met : met_[e.operand].at(e.edge))
      row_.meetings.push_back({number(found_.point(met.place)), index});
    row_.runs.push_back(run);
  }

  Workspace& w_;
  Contacts& found_;
  const PerOperand<MetOnEdges>& met_;
  int axis_;
  std::vector<Node> nodes_;
  Row row_;
};

class RowsMaker {
 public:
  RowsMaker(Workspace& w, Contacts& found)
      : w_(w),
        found_(found),
        met_{MetOnEdges(w, found, Operand::a), MetOnEdges(w, found, Operand::b)},
        edges_(w.crowded_lines.size()),
        is_wide_(w.crowded_lines.size()),
        has_row_(w.crowded_lines.size()) {}

  void run() {
    for (const Operand s : both_operands) {
      find_edges(s);
      find_wide_lines(s);
    }
    for (std::uint32_t line = 0; line < edges_.size(); ++line) {
      if (!has_edges_of_both(line)) continue;
      has_row_[line] = can_be_swept(line) ? 1 : 0;
      if (has_row_[line] != 0) {
        Row row = RowMaker(w_, found_, met_, w_.crowded_lines[line]).run(edges_[line]);
        if (faces_keep_apart(row)) {
          found_.rows.push_back(std::move(row));
          continue;
        }
        has_row_[line] = 0;
      }
      found_.has_unswept_lines = true;
    }
    leave_out_of_segments();
  }

 private:
  // Beyond an edge of which one face is not near, nothing of the other operand is.
  void find_edges(Operand s) {
    const Patch& patch = w_.patch[s];
    const EdgesOnLines on_lines(w_, s);
    for (const EdgeId e : patch.brep.edges()) {
      const HalfEdgeId h = Brep::half_edge(e);
      if (!patch.is_real(patch.brep.face_of(h)) ||
          !patch.is_real(patch.brep.face_of(Brep::twin(h))))
        continue;
      if (const auto line = on_lines.line_of(e)) edges_[*line].push_back({s, e});
    }
  }

  // Those of A come first.
  bool has_edges_of_both(std::uint32_t line) const {
    const auto& edges = edges_[line];
    return !edges.empty() && edges.front().operand != edges.back().operand;
  }

  // Those on both sides of which a face lies that has a corner on them.
  void find_wide_lines(Operand s) {
    const Patch& patch = w_.patch[s];
    std::vector<std::uint32_t> marks;
    for (const FaceId f : patch.brep.faces()) {
      if (!patch.is_real(f)) continue;
      marks.clear();
      for_each_in_face(patch.brep, f, [&](HalfEdgeId h) {
        const std::uint32_t mark = patch.on_crowded_line[patch.brep.from(h)];
        if (mark != 0 && std::ranges::find(marks, mark) == marks.end()) marks.push_back(mark);
      });
      for (const std::uint32_t mark : marks) {
        const bool any = mark == Patch::several;
        const auto last = any ? static_cast<std::uint32_t>(is_wide_.size()) : mark;
        for (std::uint32_t line = any ? 0 : mark - 1; line < last; ++line)
          if (is_wide_[line] == 0 && lies_on_both_sides(patch, f, line)) is_wide_[line] = 1;
      }
    }
  }

  bool lies_on_both_sides(const Patch& patch, FaceId f, std::uint32_t line) const {
    const PointId p = w_.crowded_lines[line][0], q = w_.crowded_lines[line][1];
    const PlaneId plane = patch.plane(f);
    const Kernel& kernel = w_.tests();
    if (kernel.side(p, plane) != Sign::zero || kernel.side(q, plane) != Sign::zero) return false;
    bool left = false, right = false;
    for_each_in_face(patch.brep, f, [&](HalfEdgeId h) {
      const Sign turn =
          kernel.turn(p, q, patch.brep.point_of(patch.brep.from(h)), kernel.main_axis(plane));
      left |= turn == Sign::positive;
      right |= turn == Sign::negative;
    });
    return left && right;
  }

  bool can_be_swept(std::uint32_t line) const {
    return is_wide_[line] == 0 && std::ranges::none_of(edges_[line], [&](const EdgeOfOperand& e) {
             return met_[e.operand].is_in_face(e.edge);
           });
  }

  bool faces_keep_apart(const Row& row) const {
    struct Beside {
      Operand operand;
      FaceId face;
      std::uint32_t from, to;
      auto operator<=>(const Beside&) const = default;
    };
    std::vector<Beside> all;
    for (const Row::Run& run : row.runs)
      for (const unsigned side : {0u, 1u}) {
        const FaceId face = w_.patch[run.operand].brep.face_of(Brep::half_edge(run.edge, side));
        all.push_back({run.operand, face, run.from, run.to});
      }
    std::ranges::sort(all);
    return std::ranges::adjacent_find(all, [](const Beside& p, const Beside& q) {
             return p.operand == q.operand && p.face == q.face && q.from < p.to;
           }) == all.end();
  }

  void leave_out_of_segments() {
    const EdgesOnLines on_lines(w_, Operand::a);
    std::erase_if(found_.segments, [&](const SegmentRecord& r) {
      if (!r.on[Operand::a].is_edge() || !r.on[Operand::b].is_edge()) return false;
      const auto line = on_lines.line_of(r.on[Operand::a].edge());
      return line && has_row_[*line] != 0;
    });
  }

  Workspace& w_;
  Contacts& found_;
  const PerOperand<MetOnEdges> met_;
  std::vector<std::vector<EdgeOfOperand>> edges_;  // per line
  std::vector<std::uint8_t> is_wide_, has_row_;    // per line
};

}  // namespace

void make_rows(Workspace& w, Contacts& found) {
  if (!w.patch[Operand::a].on_crowded_line.empty()) RowsMaker(w, found).run();
}

}  // namespace sectile
