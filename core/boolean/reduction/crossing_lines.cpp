#include "boolean/reduction/crossing_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "boolean/reduction/edges_on_lines.h"
#include "geometry/probe.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

// From where to where something runs along a line, whichever carrier is left out.
class Reach {
 public:
  using Ends = std::array<PointId, 2>;

  void add(const OnLine& piece, const AlongLineOfPoints& along) {
    Ends ends{piece.end[0].point, piece.end[1].point};
    if (!ends[0].valid()) return;  // the face of a half-space
    if (along.compare(ends[0], ends[1]) == Sign::negative) std::swap(ends[0], ends[1]);
    add(first_, {ends[0], piece.operand, piece.carrier}, Sign::positive, along);
    add(last_, {ends[1], piece.operand, piece.carrier}, Sign::negative, along);
  }

  std::optional<Ends> without(Operand operand, Entity carrier) const {
    const std::size_t first = first_[0].is_of(operand, carrier) ? 1 : 0,
                      last = last_[0].is_of(operand, carrier) ? 1 : 0;
    if (!first_[first].point.valid()) return {};
    return Ends{first_[first].point, last_[last].point};
  }

 private:
  struct End {
    PointId point;
    Operand operand = Operand::a;
    Entity carrier = {};
    bool is_of(Operand s, Entity c) const { return operand == s && carrier == c; }
  };
  using Outermost = std::array<End, 2>;  // of two carriers

  static void add(Outermost& all, const End& end, Sign outwards, const AlongLineOfPoints& along) {
    const auto is_beyond = [&](const End& other) {
      return !other.point.valid() || along.compare(end.point, other.point) == outwards;
    };
    if (is_beyond(all[0])) {
      if (!all[0].is_of(end.operand, end.carrier)) all[1] = all[0];
      all[0] = end;
    } else if (!all[0].is_of(end.operand, end.carrier) && is_beyond(all[1])) {
      all[1] = end;
    }
  }

  Outermost first_, last_;
};

class CrossingsFinder {
 public:
  CrossingsFinder(Workspace& w, LinesOfBoth& lines) : w_(w), lines_(lines) {}

  void run(std::span<const FaceOnLine> faces) {
    find_reaches();
    for (auto from = faces.begin(), to = from; from != faces.end(); from = to) {
      to = std::find_if(from, faces.end(), [&](const FaceOnLine& f) {
        return f.operand != from->operand || f.face != from->face;
      });
      find_crossings({from, to});
    }
    for (std::uint32_t line = 0; line < lines_.size(); ++line) find_ends(line);
    w_.kernel->refresh();
  }

 private:
  using Ends = Reach::Ends;

  void find_reaches() {
    for (std::uint32_t line = 0; line < lines_.size(); ++line) {
      along_.push_back(along_line(w_, line));
      reach_.emplace_back();
      if (!lines_[line].is_swept) continue;
      for (const OnLine& piece : lines_[line].all) reach_[line].add(piece, along_[line]);
    }
  }

  // Of lines in one face.
  void find_crossings(std::span<const FaceOnLine> in_face) {
    std::vector<std::uint32_t> lines;
    std::vector<Ends> reaches;
    std::vector<PieceTree::Edge> edges;
    for (const FaceOnLine& f : in_face) {
      const auto reach = reach_[f.line].without(f.operand, f.face);
      if (!reach) continue;
      lines.push_back(f.line);
      reaches.push_back(*reach);
      edges.push_back({w_.geometry.position((*reach)[0]), w_.geometry.position((*reach)[1])});
    }
    if (lines.size() < 2) return;
    const Operand s = in_face.front().operand;
    const FaceId f = in_face.front().face;
    PieceTree(edges).self_overlaps([&](std::uint32_t i, std::uint32_t j) {
      const PlaneId across_i = plane_across(w_, lines_[lines[i]], s, f),
                    across_j = plane_across(w_, lines_[lines[j]], s, f);
      if (!reaches_across(reaches[i], across_j) || !reaches_across(reaches[j], across_i)) return;
      const Construction how{w_.patch[s].plane(f), across_i, across_j, {}, {}};
      const PointId point = add_constructed(w_.geometry, how, w_.tests().construct(how));
      for (const std::uint32_t line : {lines[i], lines[j]})
        lines_[line].crossed.push_back({s, f, point});
    });
  }

  // From one side of a plane to its other side, or up to it?
  bool reaches_across(const Ends& ends, PlaneId plane) const {
    const Sign from = w_.tests().side(ends[0], plane), to = w_.tests().side(ends[1], plane);
    return from == Sign::zero || from != to;
  }

  // Of faces on a line, at edges on others.
  void find_ends(std::uint32_t line) {
    for (const OnLine& piece : lines_[line].all) {
      if (!lines_[line].is_swept || !piece.carrier.is_face()) continue;
      for (const FaceStretchEnd& end : piece.end) {
        if (!end.entity.is_edge()) continue;
        const auto other = EdgesOnLines(w_, piece.operand).line_of(end.entity.edge());
        const auto reach = reach_[line].without(piece.operand, piece.carrier);
        if (!other || !lines_[*other].is_swept || !reach) continue;
        if (along_[line].compare((*reach)[0], end.point) == Sign::negative ||
            along_[line].compare(end.point, (*reach)[1]) == Sign::negative)
          continue;
        lines_[*other].crossed.push_back({piece.operand, end.entity, end.point});
      }
    }
  }

  Workspace& w_;
  LinesOfBoth& lines_;
  std::vector<AlongLineOfPoints> along_;  // per line
  std::vector<Reach> reach_;              // per line
};

}  // namespace

void add_crossings_of_lines(Workspace& w, std::span<const FaceOnLine> faces, LinesOfBoth& lines) {
  CrossingsFinder(w, lines).run(faces);
}

}  // namespace sectile
