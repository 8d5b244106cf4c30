// Fans: edges in a plane that begin in one point, as those of a star do.
//
// Around the point all their boxes overlap. They meet elsewhere only if they leave the point in one
// direction, and then one ends within the other one.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "search/arc_partition.h"

namespace sectile {

class EdgeFans {
 public:
  static constexpr std::uint32_t none = BoxTree::no_group;

  /// The numbers of an edge's ends: equal ones are at one place. An end of which nothing is known
  /// has none.
  using Ends = std::array<std::uint32_t, 2>;
  explicit EdgeFans(std::span<const Ends> edges);

  /// How many fans there are.
  std::size_t size() const { return hubs_.size(); }
  /// Per edge: its fan, or none. Empty if there are no fans.
  const std::vector<std::uint32_t>& of_edge() const { return of_edge_; }
  std::uint32_t hub(std::size_t fan) const { return hubs_[fan]; }
  /// The fan around an end, or none.
  std::uint32_t around(std::uint32_t end) const;

  struct Member {
    std::uint32_t edge, end;  ///< and its other end
  };
  std::span<const Member> members(std::size_t fan) const {
    return std::span(members_).subspan(first_[fan], first_[fan + 1] - first_[fan]);
  }

  /// In which directions they leave the point; place_of(end) is known up to half an ulp in each
  /// coordinate.
  template <class PlaceOf>
  std::vector<SeenArc> directions(std::size_t fan, const PlaceOf& place_of) const {
    std::vector<SeenArc> arcs;
    arcs.reserve(members(fan).size());
    for (const Member& member : members(fan)) {
      const Vec3 end = place_of(member.end);
      arcs.push_back(SeenArc::from_point(place_of(hubs_[fan]), std::span(&end, 1)));
    }
    return arcs;
  }
  /// Calls visit(edge, other) for two of one fan which have more than the point in common, and for
  /// few others.
  template <class PlaceOf, class Visit>
  void for_each_pair(const PlaceOf& place_of, const Visit& visit) const {
    for (std::size_t fan = 0; fan < size(); ++fan)
      ArcPartition(directions(fan, place_of)).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
        visit(members(fan)[i].edge, members(fan)[j].edge);
      });
  }

 private:
  void find_hubs(std::span<const Ends> edges);
  std::uint32_t fan_of(const Ends& edge) const;

  std::vector<std::uint32_t> hubs_, counts_;  // per fan: the end, ascending, and of how many edges
  std::vector<std::uint32_t> of_edge_;
  std::vector<Member> members_;       // by fans
  std::vector<std::uint32_t> first_;  // per fan, and the end
};

}  // namespace sectile
