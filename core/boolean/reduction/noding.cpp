// Operands may touch themselves where their structure does not say so: an edge that lies on a face,
// or on a part of another edge. All entities through a contact place must end their segments there.
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "boolean/collect.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/pierced_faces.h"
#include "numbers/threshold.h"
#include "search/piece_tree.h"

namespace sectile {
namespace {

class Noding {
  static constexpr std::size_t few_pairs = threshold(1024, 0);

 public:
  Noding(const Workspace& w, const Contacts& found) : w_(w), kernel_(w.tests()), found_(found) {
    at_.reserve(found.places.size());
    for (const PlaceId place : found.places.ids()) at_.add(w.geometry.position(found.point(place)));
    if (found.segments.size() * at_.size() <= few_pairs) return;
    pierced_.emplace(w, found);
    if (!others().empty()) tree_.emplace(tree_of_others());
  }

  // Some records that follow each other, and so are near each other, as a rule.
  void split(std::span<const SegmentRecord> records, SegmentRecords& out) const {
    const std::vector<PlaceInside> inside = places_inside(records);
    auto from = inside.begin();
    for (std::uint32_t i = 0; i < records.size(); ++i) {
      const auto to =
          std::find_if(from, inside.end(), [&](const PlaceInside& p) { return p.record != i; });
      split(records[i], {from, to}, out);
      from = to;
    }
  }

 private:
  struct PlaceInside {
    std::uint32_t record;
    PlaceId place;
  };

  const std::vector<PlaceId>& others() const { return pierced_->others(); }

  PieceTree tree_of_others() const {
    std::vector<PieceTree::Edge> edges;
    edges.reserve(others().size());
    for (const PlaceId place : others()) edges.push_back({at_[place], at_[place]});
    return PieceTree(edges);
  }

  void split(const SegmentRecord& record, std::span<const PlaceInside> inside,
             SegmentRecords& out) const {
    PlaceId from = record.place[0];
    PerOperand<Entity> start{record.end[Operand::a][0], record.end[Operand::b][0]};
    for (std::size_t i = 0; i <= inside.size(); ++i) {
      SegmentRecord piece = record;
      const bool last = i == inside.size();
      const PlaceId to = last ? record.place[1] : inside[i].place;
      piece.place[0] = from;
      piece.place[1] = to;
      for (const Operand s : both_operands) {
        piece.end[s][0] = start[s];
        piece.end[s][1] = last ? record.end[s][1] : record.on[s];
        start[s] = record.on[s];
      }
      piece.put_in_order();
      out.push_back(piece);
      from = to;
    }
  }

  std::pair<PlaneId, PlaneId> line_of(const SegmentRecord& record) const {
    for (const Operand s : both_operands)
      if (record.on[s].is_edge())
        return line_planes(w_.patch[s], Brep::half_edge(record.on[s].edge()));
    return {w_.patch[Operand::a].plane(record.on[Operand::a].face()),
            w_.patch[Operand::b].plane(record.on[Operand::b].face())};
  }

  // Those strictly between the ends of each record, in order.
  std::vector<PlaceInside> places_inside(std::span<const SegmentRecord> records) const {
    std::vector<PlaceInside> inside;
    for_each_near(records, [&](std::uint32_t i, PlaceId place) {
      if (is_inside(records[i], place)) inside.push_back({i, place});
    });
    if (inside.empty()) return inside;
    std::sort(inside.begin(), inside.end(), [&](const PlaceInside& p, const PlaceInside& q) {
      return p.record != q.record ? p.record < q.record
                                  : precedes(records[p.record], p.place, q.place);
    });
    return inside;
  }

  // Calls visit(number of a record, place) where the place may be within the record.
  template <class Visit>
  void for_each_near(std::span<const SegmentRecord> records, const Visit& visit) const {
    for (std::uint32_t i = 0; i < records.size(); ++i) for_each_near(records[i], i, visit);
    if (!tree_) return;
    std::vector<PieceTree::Edge> edges;
    edges.reserve(records.size());
    for (const SegmentRecord& r : records) edges.push_back({at_[r.place[0]], at_[r.place[1]]});
    PieceTree::overlaps(PieceTree(edges, true), *tree_,
                        [&](std::uint32_t i, std::uint32_t other) { visit(i, others()[other]); });
  }

  // Without those in the tree. Rounding is monotonic: what is between two places on each axis is so
  // when rounded.
  template <class Visit>
  void for_each_near(const SegmentRecord& record, std::uint32_t number, const Visit& visit) const {
    Bounds near;
    for (const PlaceId end : record.place) near.add(at_[end]);
    const auto visit_near = [&](const auto& places) {
      for (const PlaceId place : places)
        if (near.contains(at_[place])) visit(number, place);
    };
    if (!pierced_) return visit_near(at_.ids());
    for (const Operand s : both_operands)
      if (record.on[s].is_face()) visit_near(pierced_->places(s, record.on[s].face()));
  }

  bool is_inside(const SegmentRecord& record, PlaceId place) const {
    if (place == record.place[0] || place == record.place[1]) return false;
    const auto [a, b] = line_of(record);
    const PointId x = found_.point(place);
    return kernel_.side(x, a) == Sign::zero && kernel_.side(x, b) == Sign::zero &&
           precedes(record, record.place[0], place) && precedes(record, place, record.place[1]);
  }

  // Of two places on the line of a record: in the direction from its first to its second one.
  bool precedes(const SegmentRecord& record, PlaceId first, PlaceId second) const {
    const auto [a, b] = line_of(record);
    const int axis = kernel_.cross_axis(a, b);
    const auto compare = [&](PlaceId p, PlaceId q) {
      return kernel_.compare(found_.point(p), found_.point(q), axis);
    };
    return compare(first, second) == compare(record.place[0], record.place[1]);
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& found_;
  Table<PlaceId, Vec3> at_;
  std::optional<PiercedFaces> pierced_;  // none where looking at all places takes no longer
  std::optional<PieceTree> tree_;        // of the others, if there are any
};

}  // namespace

void split_at_places(const Workspace& w, Contacts& found) {
  const Noding noding(w, found);
  const std::span<const SegmentRecord> all = found.segments;
  found.segments = joined(collect_ranges<SegmentRecords>(
      w, all.size(), 128, [&](std::size_t first, std::size_t last, SegmentRecords& out) {
        out.reserve(last - first);
        noding.split(all.subspan(first, last - first), out);
      }));
}

}  // namespace sectile
