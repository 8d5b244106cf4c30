#include "boolean/reduction/rows_on_lines.h"

#include <algorithm>

#include "boolean/reduction/crossing_lines.h"
#include "boolean/reduction/edges_on_lines.h"
#include "boolean/reduction/faces_on_lines.h"
#include "boolean/reduction/met_on_lines.h"
#include "boolean/reduction/points_on_lines.h"
#include "boolean/reduction/row_maker.h"
#include "search/edges_by_line.h"

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
    add_crossings_of_lines(w_, faces_, lines_);
    PlacesByPoint places(w_, found_);
    for (std::uint32_t line = 0; line < lines_.size(); ++line)
      if (lines_[line].is_swept) make_row(line, places);
    share_points_on_lines(w_, found_, places);
  }

 private:
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
    for (const FaceStretch& s :
         face_stretches(w_, f.operand, f.face, across, along_line(w_, f.line)))
      line.all.push_back({f.operand, f.face, s, {}});
  }

  // Those that have something of both operands.
  void choose_lines() {
    for (LineOfBoth& line : lines_)
      line.is_swept = line.has_edges() && has(line, Operand::a) && has(line, Operand::b);
  }
  static bool has(const LineOfBoth& line, Operand s) {
    return std::ranges::any_of(line.all, [&](const OnLine& piece) { return piece.operand == s; });
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
    const AlongLineOfPoints along = along_line(w_, number);
    found_.rows.push_back(RowMaker(w_, found_, places, along).run(line.all, line.crossed));
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
