#include "boolean/reduction/met_on_lines.h"

#include <algorithm>
#include <tuple>

#include "geometry/probe.h"

namespace sectile {
namespace {

// An end of a segment within an edge or a face.
struct Met {
  Operand operand;
  Entity in;
  PlaceId place;
  friend auto operator<=>(const Met&, const Met&) = default;
};

// A segment in a face.
struct InFace {
  Operand operand;
  FaceId face;
  std::uint32_t record;
  friend auto operator<=>(const InFace&, const InFace&) = default;
};

class MetFinder {
 public:
  MetFinder(Workspace& w, const Contacts& found, LinesOfBoth& lines)
      : w_(w), found_(found), lines_(lines) {
    for (std::uint32_t i = 0; i < found.segments.size(); ++i)
      for (const Operand s : both_operands) add(s, i);
    std::ranges::sort(met_);
    met_.erase(std::unique(met_.begin(), met_.end()), met_.end());
    std::ranges::sort(in_faces_);
  }

  void find(std::span<const FaceOnLine> faces) {
    for (std::uint32_t line = 0; line < lines_.size(); ++line)
      if (lines_[line].is_swept) find_ends(line);
    for (const FaceOnLine& f : faces)
      if (lines_[f.line].is_swept) find_crossings(f);
    w_.kernel->refresh();
  }

 private:
  void add(Operand s, std::uint32_t record) {
    const SegmentRecord& r = found_.segments[record];
    for (const unsigned k : {0u, 1u})
      if (const Entity end = r.end[s][k]; !end.is_vertex()) met_.push_back({s, end, r.place[k]});
    if (r.on[s].is_face()) in_faces_.push_back({s, r.on[s].face(), record});
  }

  void find_ends(std::uint32_t number) {
    LineOfBoth& line = lines_[number];
    const auto& [p, q] = w_.crowded_lines[number];
    const AlongLineOfPoints along(w_.tests(), p, q);
    std::vector<PlaceId> in_face;
    for (auto piece = line.all.begin(); piece != line.all.end(); ++piece) {
      if (piece->carrier.is_edge()) {
        for (const Met& met : met_in(*piece)) piece->met.push_back(met.place);
        continue;
      }
      const bool same = std::prev(piece)->carrier == piece->carrier &&
                        std::prev(piece)->operand == piece->operand;
      if (!same) in_face = met_on_line(*piece, line, along);
      piece->met = between(in_face, piece->end, along);
    }
  }

  std::span<const Met> met_in(const OnLine& piece) const {
    const auto key = [](const Met& m) { return std::tie(m.operand, m.in); };
    const auto first =
        std::ranges::lower_bound(met_, std::tie(piece.operand, piece.carrier), {}, key);
    const auto last =
        std::ranges::upper_bound(met_, std::tie(piece.operand, piece.carrier), {}, key);
    return {first, last};
  }

  // In a face, as they follow each other.
  std::vector<PlaceId> met_on_line(const OnLine& piece, const LineOfBoth& line,
                                   const AlongLineOfPoints& along) const {
    const PlaneId across = plane_across(w_, line, piece.operand, piece.carrier.face());
    std::vector<PlaceId> places;
    for (const Met& met : met_in(piece))
      if (w_.tests().side(found_.point(met.place), across) == Sign::zero)
        places.push_back(met.place);
    std::ranges::sort(places, [&](PlaceId x, PlaceId y) {
      return along.compare(found_.point(x), found_.point(y)) == Sign::positive;
    });
    return places;
  }

  std::vector<PlaceId> between(std::span<const PlaceId> places, const FaceStretch& stretch,
                               const AlongLineOfPoints& along) const {
    if (!stretch[0].point.valid()) return {places.begin(), places.end()};
    const auto first = std::ranges::partition_point(places, [&](PlaceId x) {
      return along.compare(stretch[0].point, found_.point(x)) != Sign::positive;
    });
    const auto last = std::partition_point(first, places.end(), [&](PlaceId x) {
      return along.compare(found_.point(x), stretch[1].point) == Sign::positive;
    });
    return {first, last};
  }

  void find_crossings(const FaceOnLine& f) {
    const PlaneId across = plane_across(w_, lines_[f.line], f.operand, f.face);
    const auto precedes = [&](const InFace& i) {
      return std::tie(i.operand, i.face) < std::tie(f.operand, f.face);
    };
    for (auto i = std::ranges::partition_point(in_faces_, precedes);
         i != in_faces_.end() && i->operand == f.operand && i->face == f.face; ++i) {
      const SegmentRecord& r = found_.segments[i->record];
      const Sign from = w_.tests().side(found_.point(r.place[0]), across),
                 to = w_.tests().side(found_.point(r.place[1]), across);
      if (from * to != Sign::negative) continue;
      lines_[f.line].crossed.push_back(
          {f.operand, f.face, crossing(f, r.on[other(f.operand)], across)});
    }
  }

  PointId crossing(const FaceOnLine& f, Entity by, PlaneId across) {
    const Operand s = other(f.operand);
    Construction how{};
    if (by.is_edge())
      how = edge_plane_construction(w_, s, Brep::half_edge(by.edge()), across);
    else
      how = {w_.patch[f.operand].plane(f.face), w_.patch[s].plane(by.face()), across, {}, {}};
    return add_constructed(w_.geometry, how, w_.tests().construct(how));
  }

  Workspace& w_;
  const Contacts& found_;
  LinesOfBoth& lines_;
  std::vector<Met> met_;          // by entity
  std::vector<InFace> in_faces_;  // by face
};

}  // namespace

void add_met_places(Workspace& w, const Contacts& found, std::span<const FaceOnLine> faces,
                    LinesOfBoth& lines) {
  MetFinder(w, found, lines).find(faces);
}

}  // namespace sectile
