// Edges of both operands that lie on each other along one line, as where two books have one spine.
// Each of n beside each of n others makes n² records; if all end elsewhere, each record would be
// divided at n places. But a segment is what its carriers are, of which there are 2n at most: of
// the records along it those suffice that show a carrier first, and so n² are left of n³. Where a
// sweep along the line does instead (rows_on_lines.h), there are no records.
#include <algorithm>
#include <numeric>
#include <span>
#include <tuple>

#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"
#include "numbers/disjoint_sets.h"
#include "numbers/threshold.h"
#include "search/free_stretches.h"

namespace sectile {
namespace {

// Fewer records are not worth looking at.
constexpr std::size_t many_records = threshold(256, 2);

// The records of edges on one line, in the order in which carriers are taken from them.
class RowOfEdges {
 public:
  RowOfEdges(const Workspace& w, const Contacts& found, std::span<const SegmentRecord> records)
      : records_(records) {
    for (const SegmentRecord& r : records) places_.insert(places_.end(), {r.place[0], r.place[1]});
    std::sort(places_.begin(), places_.end());
    places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
    put_in_order(w, found);
  }

  // Each record divided at all places, but for pieces that show nothing new.
  void add_pieces(SegmentRecords& out) {
    show_each(Operand::a);
    show_each(Operand::b);
    std::sort(shown_.begin(), shown_.end());
    shown_.erase(std::unique(shown_.begin(), shown_.end()), shown_.end());
    for (const Shown& s : shown_) out.push_back(piece(records_[s.record], s.stretch));
  }

 private:
  struct Shown {
    std::uint32_t stretch, record;
    friend auto operator<=>(const Shown&, const Shown&) = default;
  };

  void put_in_order(const Workspace& w, const Contacts& found) {
    const Entity edge = records_[0].on[Operand::a];
    const auto [a, b] = line_planes(w.patch[Operand::a], Brep::half_edge(edge.edge()));
    const int axis = w.tests().cross_axis(a, b);
    std::vector<std::uint32_t> order(places_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
      return i != j && w.tests().compare(found.point(places_[i]), found.point(places_[j]), axis) ==
                           Sign::positive;
    });
    at_.resize(order.size());
    for (std::uint32_t k = 0; k < order.size(); ++k) {
      along_.push_back(places_[order[k]]);
      at_[order[k]] = k;
    }
  }

  std::uint32_t number(PlaceId place) const {
    return at_[static_cast<std::size_t>(std::lower_bound(places_.begin(), places_.end(), place) -
                                        places_.begin())];
  }

  // Of each edge of an operand, the first record along each stretch.
  void show_each(Operand s) {
    std::vector<std::uint32_t> order(records_.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto edge = [&](std::uint32_t i) { return records_[i].on[s]; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t i, std::uint32_t j) { return edge(i) < edge(j); });
    FreeStretches free(places_.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (i > 0 && edge(order[i]) != edge(order[i - 1])) free.free_all();
      const std::uint32_t record = order[i];
      const auto [low, high] =
          std::minmax({number(records_[record].place[0]), number(records_[record].place[1])});
      free.take(low, high, [&](std::uint32_t k) { shown_.push_back({k, record}); });
    }
  }

  // Within a record its edges pass through the places.
  SegmentRecord piece(const SegmentRecord& whole, std::uint32_t stretch) const {
    SegmentRecord piece = whole;
    std::tie(piece.place[0], piece.place[1]) = std::minmax(along_[stretch], along_[stretch + 1]);
    for (int k = 0; k < 2; ++k)
      for (const Operand s : both_operands) {
        piece.end[s][k] = whole.on[s];
        for (int i = 0; i < 2; ++i)
          if (piece.place[k] == whole.place[i]) piece.end[s][k] = whole.end[s][i];
      }
    return piece;
  }

  std::span<const SegmentRecord> records_;
  std::vector<PlaceId> places_;    // ascending
  std::vector<std::uint32_t> at_;  // per place: its number along the line
  std::vector<PlaceId> along_;     // in their order along the line
  std::vector<Shown> shown_;
};

bool is_of_edges(const SegmentRecord& r) {
  return r.on[Operand::a].is_edge() && r.on[Operand::b].is_edge();
}

// Edges that share a segment are on one line. The records come by lines.
std::vector<std::uint32_t> sort_by_line(const Workspace& w, SegmentRecords& records) {
  const auto first_of_b = static_cast<std::uint32_t>(w.patch[Operand::a].brep.edge_count());
  DisjointSets lines(first_of_b + w.patch[Operand::b].brep.edge_count());
  for (const SegmentRecord& r : records)
    lines.unite(r.on[Operand::a].index(), first_of_b + r.on[Operand::b].index());
  const auto line = [&](const SegmentRecord& r) { return lines.first(r.on[Operand::a].index()); };
  std::stable_sort(records.begin(), records.end(),
                   [&](const SegmentRecord& p, const SegmentRecord& q) {
                     return std::tuple(line(p), p.on[Operand::a], p.on[Operand::b]) <
                            std::tuple(line(q), q.on[Operand::a], q.on[Operand::b]);
                   });
  std::vector<std::uint32_t> starts;
  for (std::uint32_t i = 0; i < records.size(); ++i)
    if (i == 0 || line(records[i]) != line(records[i - 1])) starts.push_back(i);
  starts.push_back(static_cast<std::uint32_t>(records.size()));
  return starts;
}

}  // namespace

void divide_rows(const Workspace& w, Contacts& found) {
  SegmentRecords& all = found.segments;
  if (static_cast<std::size_t>(std::count_if(all.begin(), all.end(), is_of_edges)) < many_records)
    return;
  const auto others = std::stable_partition(all.begin(), all.end(), is_of_edges);
  SegmentRecords of_edges(all.begin(), others);
  all.erase(all.begin(), others);
  const std::vector<std::uint32_t> starts = sort_by_line(w, of_edges);
  for (std::size_t i = 0; i + 1 < starts.size(); ++i) {
    const std::span<const SegmentRecord> records =
        std::span(of_edges).subspan(starts[i], starts[i + 1] - starts[i]);
    if (records.size() < many_records) {
      all.insert(all.end(), records.begin(), records.end());
    } else {
      RowOfEdges(w, found, records).add_pieces(all);
    }
  }
}

}  // namespace sectile
