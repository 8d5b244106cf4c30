// Cuts a plane region with any number of holes into triangles, in one sweep.
//
// The sweep goes through the places of the corners in their order. It sees edges only, never how
// they follow each other in loops: around each place the edges that arrive from the left and those
// that leave to the right bound sectors of the region, and every sector is a corner of its own.
// So it makes no difference how loops that touch were traced, and an edge through whose interior a
// place lies is divided there exactly if another edge ends at this place on the side of the edge
// on which the region lies; on the other side it goes on undivided.
//
// On the sweep line, from bottom to top, rightward edges (the region above them) and leftward
// edges (the region below) alternate. Both edges of a slit lie on the line, the leftward one below.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "geometry/sweep_front.h"
#include "geometry/sweep_line.h"

namespace sectile {

template <class Predicates>
class RegionSweep {
 public:
  using Triangles = typename SweepFront<Predicates>::Triangles;

  /// Loop k has the corners loop_ends[k - 1] to loop_ends[k] - 1.
  RegionSweep(const Predicates& exact, std::span<const std::uint32_t> loop_ends,
              Triangles& triangles)
      : exact_(exact),
        corners_(loop_ends.empty() ? 0 : loop_ends.back()),
        line_(corners_),
        front_(exact, triangles),
        next_(corners_),
        previous_(corners_),
        place_(corners_),
        chains_(corners_) {
    link_loops(loop_ends);
    sort_places();
    front_.reserve(corners_ + corners_ / 2);
  }

  void run() {
    for (std::uint32_t first = 0; first < corners_;) {
      here_ = place_[order_[first]];
      std::uint32_t last = first + 1;
      while (last < corners_ && place_[order_[last]] == here_) ++last;
      visit(first, last);
      first = last;
    }
    require(line_.empty());
  }

 private:
  static constexpr std::uint32_t none = SweepLine::none;

  // An edge has the number of the corner it leaves.
  bool is_rightward(std::uint32_t edge) const { return place_[edge] < place_[next_[edge]]; }
  std::uint32_t left_end(std::uint32_t edge) const {
    return is_rightward(edge) ? edge : next_[edge];
  }
  std::uint32_t right_end(std::uint32_t edge) const {
    return is_rightward(edge) ? next_[edge] : edge;
  }
  bool ends_here(std::uint32_t edge) const { return place_[right_end(edge)] == here_; }
  /// Positive: this place lies above the edge.
  Sign height_above(std::uint32_t edge) const {
    return exact_.turn(left_end(edge), right_end(edge), corner_);
  }
  bool contains_place(std::uint32_t edge) const {
    return ends_here(edge) || height_above(edge) == Sign::zero;
  }

  static void require(bool legal) {
    if (!legal) throw InternalError("triangulation: the loops of a face do not bound a region");
  }

  void link_loops(std::span<const std::uint32_t> loop_ends) {
    std::uint32_t first = 0;
    for (const std::uint32_t end : loop_ends) {
      for (std::uint32_t corner = first; corner < end; ++corner) {
        next_[corner] = corner + 1 == end ? first : corner + 1;
        previous_[next_[corner]] = corner;
      }
      first = end;
    }
  }

  void sort_places() {
    order_.resize(corners_);
    for (std::uint32_t corner = 0; corner < corners_; ++corner) order_[corner] = corner;
    std::sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
      const Sign order = exact_.compare(a, b);
      return order == Sign::zero ? a < b : order == Sign::positive;
    });
    for (std::uint32_t i = 1; i < corners_; ++i) {
      const bool same = exact_.compare(order_[i - 1], order_[i]) == Sign::zero;
      place_[order_[i]] = place_[order_[i - 1]] + (same ? 0 : 1);
    }
  }

  void visit(std::uint32_t first, std::uint32_t last) {
    corner_ = order_[first];
    gather(first, last);
    if (left_.empty() && right_.empty()) return;  // edges without length
    sort_right();
    const bool open_below = gap_.below != none && is_rightward(gap_.below);
    require(alternates(left_, open_below) && alternates(right_, open_below));
    require(left_.size() % 2 == right_.size() % 2);
    close_left_sectors();
    go_on(open_below);
    open_right_sectors();
    update_line();
  }

  /// Collects the edges of this place: left_ in order, right_ not yet.
  void gather(std::uint32_t first, std::uint32_t last) {
    right_.clear();
    std::size_t ending = 0;
    std::uint32_t known = none;
    for (std::uint32_t i = first; i < last; ++i) {
      const std::uint32_t corner = order_[i];
      for (const std::uint32_t edge : {previous_[corner], corner}) {
        const std::uint32_t other = place_[edge == corner ? next_[corner] : edge];
        if (other < here_) {
          ++ending;
          known = edge;
        } else if (other > here_) {
          right_.push_back(edge);
        }
      }
    }
    find_left(known);
    passing_ = left_.size() - ending;
    require(static_cast<std::size_t>(std::count_if(left_.begin(), left_.end(), [this](auto edge) {
              return ends_here(edge);
            })) == ending);
    for (const std::uint32_t edge : left_) {
      if (!ends_here(edge)) right_.push_back(edge);
    }
  }

  /// The edges on the line that contain this place are neighbours; one of them may be known.
  void find_left(std::uint32_t known) {
    left_.clear();
    if (known == none) {
      gap_ =
          line_.locate([this](std::uint32_t edge) { return height_above(edge) == Sign::positive; });
    } else {
      gap_ = {line_.below(known), known};
      while (gap_.below != none && contains_place(gap_.below)) {
        gap_ = {line_.below(gap_.below), gap_.below};
      }
    }
    while (gap_.above != none && (gap_.above == known || contains_place(gap_.above))) {
      left_.push_back(gap_.above);
      gap_.above = line_.above(gap_.above);
    }
  }

  void sort_right() {
    if (right_.size() < 2) return;
    std::sort(right_.begin(), right_.end(), [this](std::uint32_t a, std::uint32_t b) {
      const Sign turn = direction_turn(a, b);
      if (turn != Sign::zero) return turn == Sign::positive;
      return a < b;
    });
    // The order of edges on each other follows from the region: at both sides of them, or neither.
    bool rightward = gap_.below == none || !is_rightward(gap_.below);
    for (std::size_t i = 0; i + 1 < right_.size(); ++i, rightward = !rightward) {
      if (is_rightward(right_[i]) == rightward) continue;
      for (std::size_t k = i + 1;
           k < right_.size() && direction_turn(right_[i], right_[k]) == Sign::zero; ++k) {
        if (is_rightward(right_[k]) == rightward) {
          std::swap(right_[i], right_[k]);
          break;
        }
      }
    }
  }
  Sign direction_turn(std::uint32_t a, std::uint32_t b) const {
    return exact_.turn(corner_, right_end(a), right_end(b));
  }

  bool alternates(const std::vector<std::uint32_t>& edges, bool open) const {
    for (const std::uint32_t edge : edges) {
      if (is_rightward(edge) == open) return false;
      open = !open;
    }
    return true;
  }

  /// The corner of the sector counter-clockwise between an edge that leaves and one that arrives.
  std::uint32_t sector_corner(std::uint32_t leaving, std::uint32_t arriving) const {
    if (place_[leaving] == here_) return leaving;
    return place_[next_[arriving]] == here_ ? next_[arriving] : corner_;
  }

  void close_left_sectors() {
    for (std::size_t i = 0; i + 1 < left_.size(); ++i) {
      if (is_rightward(left_[i])) {
        front_.close(chains_[left_[i]], sector_corner(left_[i + 1], left_[i]));
      }
    }
  }

  /// The sectors that reach from the left to the right of this place: below, above, or round it.
  void go_on(bool open_below) {
    if (left_.empty()) {
      if (!open_below) return;
      const auto [lower, upper] =
          front_.split(chains_[gap_.below], sector_corner(right_.back(), right_.front()));
      chains_[gap_.below] = lower;
      chains_[right_.back()] = upper;
    } else if (right_.empty()) {
      if (!open_below) return;
      chains_[gap_.below] = front_.merge(chains_[gap_.below], chains_[left_.back()],
                                         sector_corner(left_.front(), left_.back()));
    } else {
      if (open_below && left_.front() != right_.front()) {
        front_.add_top(chains_[gap_.below], sector_corner(left_.front(), right_.front()));
      }
      if (!is_rightward(left_.back())) return;
      SweepChain upper = chains_[left_.back()];
      if (left_.back() != right_.back()) {
        front_.add_bottom(upper, sector_corner(right_.back(), left_.back()));
      }
      chains_[right_.back()] = upper;
    }
  }

  void open_right_sectors() {
    for (std::size_t i = 0; i + 1 < right_.size(); ++i) {
      if (is_rightward(right_[i])) {
        chains_[right_[i]] = front_.start(sector_corner(right_[i], right_[i + 1]));
      }
    }
  }

  void update_line() {
    const std::size_t kept = passing_ > 0 ? 0 : std::min(left_.size(), right_.size());
    for (std::size_t i = kept; i < left_.size(); ++i) line_.remove(left_[i]);
    for (std::size_t i = 0; i < kept; ++i) line_.replace(left_[i], right_[i]);
    std::uint32_t below = kept > 0 ? right_[kept - 1] : gap_.below;
    for (std::size_t i = kept; i < right_.size(); ++i) {
      line_.insert_above(below, right_[i]);
      below = right_[i];
    }
  }

  const Predicates& exact_;
  std::uint32_t corners_;
  SweepLine line_;
  SweepFront<Predicates> front_;
  std::vector<std::uint32_t> next_, previous_;
  std::vector<std::uint32_t> place_;  ///< corners at the same place share a number; in order
  std::vector<std::uint32_t> order_;  ///< the corners in the order of their places
  std::vector<SweepChain> chains_;    ///< of a rightward edge on the line: the chain above it

  // The place being visited.
  std::uint32_t here_ = 0;
  std::uint32_t corner_ = 0;                 ///< one of its corners
  std::vector<std::uint32_t> left_, right_;  ///< its edges from bottom to top
  std::size_t passing_ = 0;                  ///< how many of them are in both
  SweepLine::Gap gap_;                       ///< the edges just below and above them
};

}  // namespace sectile
