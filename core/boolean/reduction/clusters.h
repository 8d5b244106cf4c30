// Clusters: faces of both solids that hang together by pairs that may meet, and by their vertices.
//
// Needed beside lines where very many edges run (boolean/near/crowded_lines.h), unless they are
// rows: a place there divides what is of one cluster with it, and nothing else.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "boolean/reduction/reduction.h"
#include "search/piece_tree.h"

namespace sectile {

class Clusters {
 public:
  /// `candidates`: the pairs that are tested. There are none unless there are crowded lines.
  Clusters(const Workspace& w, const FacePairs& candidates);

  bool any() const { return !of_[Operand::a].empty(); }
  std::uint32_t count() const { return count_; }
  std::uint32_t of(const SegmentRecord& record) const {
    return of(Operand::a, record.on[Operand::a]);
  }
  std::uint32_t of(const Contact& contact) const { return of(Operand::a, contact.on[Operand::a]); }

 private:
  std::uint32_t of(Operand s, Entity entity) const;

  const Workspace& w_;
  PerOperand<Table<FaceId, std::uint32_t>> of_;
  std::uint32_t count_ = 0;
};

/// The places of each cluster.
class PlacesOfClusters {
 public:
  PlacesOfClusters(const Clusters& clusters, const Contacts& found,
                   const Table<PlaceId, Vec3>& positions);

  /// Calls visit(number of a record, place) where the place is of the record's cluster and may be
  /// within it.
  template <class Visit>
  void for_each_near(std::span<const SegmentRecord> records, const Visit& visit) const {
    std::vector<std::uint32_t> order = by_cluster(records);
    for (std::size_t from = 0, to; from < order.size(); from = to) {
      const std::uint32_t cluster = clusters_.of(records[order[from]]);
      for (to = from + 1; to < order.size() && clusters_.of(records[order[to]]) == cluster;) ++to;
      std::vector<PieceTree::Edge> edges;
      for (std::size_t i = from; i < to; ++i)
        edges.push_back(
            {positions_[records[order[i]].place[0]], positions_[records[order[i]].place[1]]});
      PieceTree::overlaps(PieceTree(edges), *tree_[cluster], [&](std::uint32_t i, std::uint32_t j) {
        visit(order[from + i], places_[first_[cluster] + j].place);
      });
    }
  }

 private:
  struct OfCluster {
    std::uint32_t cluster;
    PlaceId place;
    friend auto operator<=>(const OfCluster&, const OfCluster&) = default;
  };

  std::vector<std::uint32_t> by_cluster(std::span<const SegmentRecord> records) const;

  const Clusters& clusters_;
  const Table<PlaceId, Vec3>& positions_;
  std::vector<OfCluster> places_;
  std::vector<std::uint32_t> first_;            // per cluster, and the end
  std::vector<std::optional<PieceTree>> tree_;  // per cluster that has places
};

}  // namespace sectile
