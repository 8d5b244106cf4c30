// Does the rim of a piece of surface, seen along an axis, wind around every point once or not at
// all?
#pragma once

#include <span>
#include <vector>

#include "geometry/kernel.h"

namespace sectile {

/// An edge of the rim; the piece lies to its left, seen from outside.
struct RimEdge {
  PointId from, to;
};

/// Sweeps over the edges as they are seen along an axis. Sure if it says yes. It says no also where
/// edges only touch in more than their ends.
class RimSweep {
 public:
  explicit RimSweep(const Kernel& kernel) : kernel_(kernel) {}

  bool winds_once(std::span<const RimEdge> rim, int axis, bool behind);

 private:
  struct Edge {
    PointId left, right;
    bool opens;  ///< the piece is above it
  };
  struct Event {
    PointId point;
    std::uint32_t edge;
  };

  Sign before(PointId p, PointId q) const;
  Sign turn(const Edge& e, PointId p) const { return kernel_.turn(e.left, e.right, p, axis_); }
  bool read(std::span<const RimEdge> rim, bool behind);
  bool pass(std::span<const Event> starting, std::size_t ending, PointId point);
  bool sort_starting(std::span<const Event> starting);
  bool stay_apart(const Edge& below, const Edge& above) const;

  const Kernel& kernel_;
  int axis_ = 0, u_ = 1, v_ = 2;
  std::vector<Edge> edges_;
  std::vector<Event> starts_, ends_;
  std::vector<std::uint32_t> front_, starting_;  // edges, from below
};

}  // namespace sectile
