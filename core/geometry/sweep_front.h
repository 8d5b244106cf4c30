// The chains on the left of what a sweep has not yet cut into triangles.
//
// Between two neighbouring edges on the sweep line, the part of the region that is not yet in a
// triangle ends to the left in one chain of corners:
//
//        top •--------- upper edge
//             \                         From bottom to top a chain turns left or runs straight at
//              • newest                 every corner between its ends (else the triangle there
//             /                         would have been cut off), and from the newest corner,
//     bottom •--------- lower edge      the last in the order of the sweep, the order falls
//                                       towards both ends.
//
// The newest corner is therefore seen from every point that the sweep meets next in this part.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "numbers/sign.h"
#include "sectile/errors.h"

namespace sectile {

/// One chain; the members are numbers of links.
struct SweepChain {
  std::uint32_t bottom = 0, top = 0, newest = 0;
};

template <class Predicates>
class SweepFront {
 public:
  using Triangles = std::vector<std::array<std::uint32_t, 3>>;

  SweepFront(const Predicates& exact, Triangles& triangles)
      : exact_(exact), triangles_(triangles) {}

  void reserve(std::size_t links) { links_.reserve(links); }

  SweepChain start(std::uint32_t corner) {
    const std::uint32_t link = add(corner);
    return {link, link, link};
  }

  /// The lower edge ends in the corner, and another begins there.
  void add_bottom(SweepChain& chain, std::uint32_t corner) {
    const std::uint32_t seen = cut_upwards(chain.bottom, corner);
    const std::uint32_t link = add(corner);
    join(link, seen);
    chain.bottom = chain.newest = link;
  }

  /// The upper edge ends in the corner, and another begins there.
  void add_top(SweepChain& chain, std::uint32_t corner) {
    const std::uint32_t seen = cut_downwards(chain.top, corner);
    const std::uint32_t link = add(corner);
    join(seen, link);
    chain.top = chain.newest = link;
  }

  /// Both edges end in the corner. Only between edges that lie on each other is there nothing to
  /// cut.
  void close(const SweepChain& chain, std::uint32_t corner) {
    for (std::uint32_t at = chain.bottom; links_[at].above != none; at = links_[at].above) {
      if (cut_above(at, corner) == Sign::negative) {
        throw InternalError("triangulation: the edges of a face cross each other");
      }
    }
  }

  /// The corner lies between the edges; both parts go on beyond it.
  std::array<SweepChain, 2> split(const SweepChain& chain, std::uint32_t corner) {
    const std::uint32_t seen_above = cut_upwards(chain.newest, corner);
    const std::uint32_t seen_below = cut_downwards(chain.newest, corner);
    SweepChain lower{chain.bottom, 0, 0}, upper{0, chain.top, 0};
    std::uint32_t second = seen_above;
    if (seen_above == seen_below) {  // the newest itself; it goes to both parts
      second = add(links_[seen_above].corner);
      const std::uint32_t next = links_[seen_above].above;
      if (next == none) {
        upper.top = second;
      } else {
        join(second, next);
      }
    }
    lower.top = lower.newest = add(corner);
    upper.bottom = upper.newest = add(corner);
    join(seen_below, lower.top);
    join(upper.bottom, second);
    return {lower, upper};
  }

  /// The part below ends above in the corner, and the part above ends below in it.
  SweepChain merge(SweepChain lower, SweepChain upper, std::uint32_t corner) {
    add_top(lower, corner);
    const std::uint32_t seen = cut_upwards(upper.bottom, corner);
    join(lower.top, seen);
    return {lower.bottom, upper.top, lower.newest};
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  struct Link {
    std::uint32_t corner, below = none, above = none;
  };

  std::uint32_t add(std::uint32_t corner) {
    links_.push_back({corner});
    return static_cast<std::uint32_t>(links_.size() - 1);
  }
  void join(std::uint32_t below, std::uint32_t above) {
    links_[below].above = above;
    links_[above].below = below;
  }

  /// Cuts off the triangle of a link, the corner and the link above, if its sign is positive.
  Sign cut_above(std::uint32_t link, std::uint32_t corner) {
    const std::uint32_t low = links_[link].corner, high = links_[links_[link].above].corner;
    const Sign sign = exact_.turn(low, corner, high);
    if (sign == Sign::positive) triangles_.push_back({low, corner, high});
    return sign;
  }
  std::uint32_t cut_upwards(std::uint32_t link, std::uint32_t corner) {
    while (links_[link].above != none && cut_above(link, corner) == Sign::positive) {
      link = links_[link].above;
    }
    return link;
  }
  std::uint32_t cut_downwards(std::uint32_t link, std::uint32_t corner) {
    while (links_[link].below != none && cut_above(links_[link].below, corner) == Sign::positive) {
      link = links_[link].below;
    }
    return link;
  }

  const Predicates& exact_;
  Triangles& triangles_;
  std::vector<Link> links_;
};

}  // namespace sectile
