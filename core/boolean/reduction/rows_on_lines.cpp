#include "boolean/reduction/rows_on_lines.h"

#include <algorithm>

#include "boolean/reduction/edges_on_lines.h"
#include "boolean/reduction/faces_on_lines.h"
#include "boolean/reduction/met_on_lines.h"
#include "boolean/reduction/row_maker.h"
#include "search/edges_by_line.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

class RowsMaker {
 public:
  RowsMaker(Workspace& w, const ContactTable& table, Contacts& found)
      : w_(w), table_(table), found_(found), lines_(w.crowded_lines.size()) {}

  void run() {
    for (const Operand s : both_operands) find_edges(s);
    faces_ = faces_on_lines(w_, table_, found_, lines_);
    for (const FaceOnLine& f : faces_) add_stretches(f);
    choose_lines();
    leave_out_of_segments();
    add_met_places(w_, found_, faces_, lines_);
    PlacesByPoint places(w_, found_);
    for (std::uint32_t line = 0; line < lines_.size(); ++line)
      if (lines_[line].is_swept) make_row(line, places);
  }

 private:
  AlongLineOfPoints along(std::uint32_t line) const {
    const auto& [p, q] = w_.crowded_lines[line];
    return {w_.tests(), p, q};
  }

  // Beyond an edge of which one face is not near, nothing of the other operand is.
  void find_edges(Operand s) {
    const Patch& patch = w_.patch[s];
    const Brep& brep = patch.brep;
    const EdgesOnLines on_lines(w_, s);
    for (const EdgeId e : brep.edges()) {
      const HalfEdgeId h = Brep::half_edge(e);
      if (!patch.is_real(brep.face_of(h)) || !patch.is_real(brep.face_of(Brep::twin(h)))) continue;
      const auto line = on_lines.line_of(e);
      if (!line) continue;
      const VertexId from = brep.from(h), to = brep.to(h);
      lines_[*line].all.push_back(
          {s, e, {{{brep.point_of(from), from}, {brep.point_of(to), to}}}, {}});
    }
  }

  void add_stretches(const FaceOnLine& f) {
    LineOfBoth& line = lines_[f.line];
    if (w_.patch[f.operand].unbounded) {
      line.all.push_back({f.operand, f.face, {{{{}, f.face}, {{}, f.face}}}, {}});
      return;
    }
    const PlaneId across = plane_across(w_, line, f.operand, f.face);
    for (const FaceStretch& s : face_stretches(w_, f.operand, f.face, across, along(f.line)))
      line.all.push_back({f.operand, f.face, s, {}});
  }

  // Those that have something of both operands, and do not cross each other in a face.
  void choose_lines() {
    for (LineOfBoth& line : lines_)
      line.is_swept = line.has_edges() && has(line, Operand::a) && has(line, Operand::b);
    for (auto from = faces_.begin(), to = from; from != faces_.end(); from = to) {
      to = std::find_if(from, faces_.end(), [&](const FaceOnLine& f) {
        return f.operand != from->operand || f.face != from->face;
      });
      if (to - from > 1) leave_out_lines_that_cross({from, to});
    }
  }

  // Of lines in one face.
  void leave_out_lines_that_cross(std::span<const FaceOnLine> in_face) {
    std::vector<PieceTree::Edge> edges;
    for (const FaceOnLine& f : in_face) {
      const auto& [p, q] = w_.crowded_lines[f.line];
      edges.push_back({w_.geometry.position(p), w_.geometry.position(q)});
    }
    PieceTree(edges).self_overlaps([&](std::uint32_t i, std::uint32_t j) {
      const std::uint32_t l = in_face[i].line, m = in_face[j].line;
      if (!reaches_across(l, m, in_face[i]) || !reaches_across(m, l, in_face[i])) return;
      found_.has_unswept_lines |= lines_[l].is_swept || lines_[m].is_swept;
      lines_[l].is_swept = lines_[m].is_swept = false;
    });
  }

  static bool has(const LineOfBoth& line, Operand s) {
    return std::ranges::any_of(line.all, [&](const OnLine& piece) { return piece.operand == s; });
  }
  // Do a line's edges reach from one side of another line in the plane of a face to its other side,
  // or up to it?
  bool reaches_across(std::uint32_t line, std::uint32_t other, const FaceOnLine& f) const {
    const PlaneId across = plane_across(w_, lines_[other], f.operand, f.face);
    const auto& [p, q] = w_.crowded_lines[line];
    const Sign from = w_.tests().side(p, across), to = w_.tests().side(q, across);
    return from == Sign::zero || from != to;
  }

  void leave_out_of_segments() {
    const PerOperand<EdgesOnLines> on_lines{EdgesOnLines(w_, Operand::a),
                                            EdgesOnLines(w_, Operand::b)};
    std::erase_if(found_.segments, [&](const SegmentRecord& r) {
      for (const Operand s : both_operands)
        if (r.on[s].is_edge()) {
          const auto line = on_lines[s].line_of(r.on[s].edge());
          return line && lines_[*line].is_swept;
        }
      return is_on_swept_line(r);
    });
  }

  // Of two faces.
  bool is_on_swept_line(const SegmentRecord& r) const {
    const auto lies_on = [&](const FaceOnLine& f) {
      const std::array<PointId, 2>& line = w_.crowded_lines[f.line];
      return lines_[f.line].is_swept && std::ranges::all_of(r.place, [&](PlaceId place) {
               return are_on_one_line(w_.tests(), line[0], line[1], found_.point(place));
             });
    };
    const std::span<const FaceOnLine> of_b = lines_of(Operand::b, r.on[Operand::b].face());
    if (of_b.empty()) return false;
    return std::ranges::any_of(
        lines_of(Operand::a, r.on[Operand::a].face()), [&](const FaceOnLine& f) {
          return std::ranges::binary_search(of_b, f.line, {}, &FaceOnLine::line) && lies_on(f);
        });
  }

  std::span<const FaceOnLine> lines_of(Operand s, FaceId face) const {
    const auto first = std::ranges::lower_bound(faces_, FaceOnLine{s, face, 0});
    const auto last = std::find_if(
        first, faces_.end(), [&](const FaceOnLine& f) { return f.operand != s || f.face != face; });
    return {first, last};
  }

  void make_row(std::uint32_t number, PlacesByPoint& places) {
    LineOfBoth& line = lines_[number];
    std::ranges::stable_sort(line.all, {}, &OnLine::operand);
    const AlongLineOfPoints along_line = along(number);
    found_.rows.push_back(RowMaker(w_, found_, places, along_line).run(line.all, line.crossed));
  }

  Workspace& w_;
  const ContactTable& table_;
  Contacts& found_;
  LinesOfBoth lines_;
  std::vector<FaceOnLine> faces_;
};

}  // namespace

void make_rows(Workspace& w, const ContactTable& table, Contacts& found) {
  if (!w.patch[Operand::a].on_crowded_line.empty()) RowsMaker(w, table, found).run();
}

}  // namespace sectile
