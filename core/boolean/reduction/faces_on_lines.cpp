#include "boolean/reduction/faces_on_lines.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "boolean/reduction/edges_on_lines.h"

namespace sectile {
namespace {

class FacesFinder {
 public:
  FacesFinder(const Workspace& w, const ContactTable& table, const Contacts& found,
              const LinesOfBoth& lines)
      : w_(w), table_(table), found_(found), lines_(lines) {}

  std::vector<FaceOnLine> run() {
    for (const Operand s : both_operands) {
      add_faces_with_corners(s);
      add_faces_with_edges(s);
    }
    if (to_visit_.empty()) return {};
    find_beside();
    std::vector<FaceOnLine> faces;
    while (!to_visit_.empty()) {
      const FaceOnLine f = to_visit_.back();
      to_visit_.pop_back();
      if (!lies_on_both_sides(f)) continue;
      faces.push_back(f);
      add_beside(f);
    }
    std::ranges::sort(faces);
    return faces;
  }

 private:
  // Two faces of which one runs in or across the other.
  struct Beside {
    Operand operand;
    FaceId face, across;
    friend auto operator<=>(const Beside&, const Beside&) = default;
  };

  void add(const FaceOnLine& f) {
    if (lines_[f.line].has_edges() && seen_.insert(f).second) to_visit_.push_back(f);
  }

  void add_faces_with_corners(Operand s) {
    const Patch& patch = w_.patch[s];
    for (const FaceId f : patch.brep.faces()) {
      if (!patch.is_real(f)) continue;
      for_each_in_face(patch.brep, f, [&](HalfEdgeId h) {
        const std::uint32_t mark = patch.on_crowded_line[patch.brep.from(h)];
        if (mark != 0 && mark != Patch::several) add({s, f, mark - 1});
        for (std::uint32_t line = 0; mark == Patch::several && line < lines_.size(); ++line)
          add({s, f, line});
      });
    }
  }

  // Of the other operand.
  void add_faces_with_edges(Operand s) {
    const EdgesOnLines on_lines(w_, other(s));
    for (const SegmentRecord& r : found_.segments)
      if (r.on[s].is_face() && r.on[other(s)].is_edge())
        if (const auto line = on_lines.line_of(r.on[other(s)].edge()))
          add({s, r.on[s].face(), *line});
  }

  void find_beside() {
    const auto add_both = [&](FaceId f, FaceId g) {
      beside_.push_back({Operand::a, f, g});
      beside_.push_back({Operand::b, g, f});
    };
    for (const SegmentRecord& r : found_.segments)
      if (r.on[Operand::a].is_face() && r.on[Operand::b].is_face())
        add_both(r.on[Operand::a].face(), r.on[Operand::b].face());
    for (const PairOfFaces& pair : table_.pairs)
      if (pair.coplanar) add_both(pair.face[Operand::a], pair.face[Operand::b]);
    std::ranges::sort(beside_);
  }

  void add_beside(const FaceOnLine& f) {
    const auto precedes = [&](const Beside& b) {
      return std::tie(b.operand, b.face) < std::tie(f.operand, f.face);
    };
    for (auto b = std::ranges::partition_point(beside_, precedes);
         b != beside_.end() && b->operand == f.operand && b->face == f.face; ++b)
      add({other(f.operand), b->across, f.line});
  }

  bool lies_on_both_sides(const FaceOnLine& f) const {
    const Patch& patch = w_.patch[f.operand];
    for (const PointId p : w_.crowded_lines[f.line])
      if (w_.tests().side(p, patch.plane(f.face)) != Sign::zero) return false;
    if (patch.unbounded) return true;
    const PlaneId across = plane_across(w_, lines_[f.line], f.operand, f.face);
    bool left = false, right = false;
    for_each_in_face(patch.brep, f.face, [&](HalfEdgeId h) {
      const Sign side = w_.tests().side(patch.brep.point_of(patch.brep.from(h)), across);
      left |= side == Sign::positive;
      right |= side == Sign::negative;
    });
    return left && right;
  }

  const Workspace& w_;
  const ContactTable& table_;
  const Contacts& found_;
  const LinesOfBoth& lines_;
  std::vector<Beside> beside_;  // by face
  std::set<FaceOnLine> seen_;
  std::vector<FaceOnLine> to_visit_;
};

}  // namespace

std::vector<FaceOnLine> faces_on_lines(const Workspace& w, const ContactTable& table,
                                       const Contacts& found, const LinesOfBoth& lines) {
  return FacesFinder(w, table, found, lines).run();
}

}  // namespace sectile
