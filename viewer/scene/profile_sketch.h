// Drawing and changing the outline of an extrusion or a revolution: polygons with holes in a plane.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace sectile::viewer {

using Loop = std::vector<Vec2>;

/// One side of a loop, or one that is being drawn, in lengths and degrees from the x axis.
struct SketchSide {
  double length = 0, degrees = 0;
};
SketchSide side_between(const Vec2& from, const Vec2& to);
/// Where a side ends; exact along the axes.
Vec2 end_of(const Vec2& from, const SketchSide& side);

class ProfileSketch {
 public:
  ProfileSketch() = default;
  explicit ProfileSketch(const Profile& profile);

  struct Corner {
    std::size_t loop = 0, corner = 0;
    friend bool operator==(const Corner&, const Corner&) = default;
  };

  const std::vector<Loop>& loops() const { return now_.loops; }
  const Loop& drawn() const { return now_.drawn; }
  Vec2 at(const Corner& corner) const { return now_.loops.at(corner.loop).at(corner.corner); }
  Vec2 before(const Corner& corner) const;

  // Drawing. Each of these is one step of undo().
  void add_corner(const Vec2& place);  ///< of the loop being drawn
  bool close();                        ///< the loop being drawn; false: it has too few corners
  void add_loop(Loop loop);
  void move(const Corner& corner, const Vec2& place);
  void insert_before(const Corner& corner, const Vec2& place);
  void remove(const Corner& corner);  ///< with its loop, if two would be left
  void remove_loop(std::size_t loop);

  /// Between begin_move and the next change all moves are one step.
  void begin_move() { keep(), moving_ = true; }
  void end_move() { moving_ = false; }
  bool can_undo() const { return !before_.empty(); }
  void undo();

  /// The loop around the largest area is the outer one.
  Profile profile() const;
  /// Why there is no such solid, in words; empty if all is well.
  std::string problem(Primitive primitive) const;

 private:
  struct State {
    std::vector<Loop> loops;
    Loop drawn;
  };
  void keep() {
    if (!moving_) before_.push_back(now_);
  }

  State now_;
  std::vector<State> before_;
  bool moving_ = false;
};

Loop rectangle_loop(const Vec2& centre, double width, double height);
Loop circle_loop(const Vec2& centre, double radius, std::uint32_t corners);

/// A placement whose xy plane lies in a plane of the world, z along its normal: the origin is the
/// world's, moved along the normal. Exact for normals along the axes.
Placement placement_on_plane(const Vec3& point, const Vec3& normal);

}  // namespace sectile::viewer
