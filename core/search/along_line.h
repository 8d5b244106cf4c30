// How faces around a line are seen by one who looks along it.
//
// Two faces that touch the line with their boundaries, and leave it in different directions, meet
// in nothing but the line, however near to it they are.
#pragma once

#include <span>

#include "numbers/sign.h"
#include "search/box.h"

namespace sectile {

class AlongLine {
 public:
  /// Through two points, of which the rounded positions are known.
  AlongLine(const Vec3& from, const Vec3& to);

  /// A box that says in two coordinates in which directions what these points span leaves the line,
  /// and in the third one how far it reaches along it. What has points in common off the line has
  /// boxes that overlap.
  Box box(std::span<const Vec3> on_line, std::span<const Vec3> beside) const;
  /// For all directions; how far points on the line reach.
  Box reach(std::span<const Vec3> on_line) const;

  /// The shorter way around the line from the direction of one point to that of another:
  /// counter-clockwise, seen from where the line leads to? Zero if doubles do not tell.
  Sign turn(const Vec3& from, const Vec3& to) const;
  /// How far the direction of one point is turned from that of another, by the shorter way: from 1
  /// (not at all) down to -1 (half a turn), off by `error` at most. Zero and one if doubles do not
  /// tell.
  struct Turned {
    double by, error;
  };
  Turned turned(const Vec3& from, const Vec3& to) const;
  /// Do two points on the line follow each other as its ends do? Zero if doubles do not tell.
  Sign along(const Vec3& from, const Vec3& to) const;

 private:
  Vec3 seen(const Vec3& p) const;
  double error(const Vec3& p) const;
  double error_of_products(const Vec3& p, const Vec3& q) const;

  Vec3 from_;
  int axis_;  // on which the line is longest
  double length_, slope_[2], size_;
};

}  // namespace sectile
