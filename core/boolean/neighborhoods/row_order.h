// The half-planes of a row's edges and faces, in their order around its line.
#pragma once

#include <cstdint>
#include <vector>

#include "boolean/direction.h"
#include "boolean/neighborhoods/neighborhoods.h"

namespace sectile {

/// Two for each run: 2 i is the half-plane that is forward along the line, 2 i + 1 the other one.
using RowSide = std::uint32_t;

inline bool is_forward(RowSide side) {
  return side % 2 == 0;
}
inline RowSide beyond_edge(RowSide side) {
  return side ^ 1u;
}

class RowOrder {
 public:
  RowOrder(const Workspace& w, const Contacts& contacts, const Row& row);

  /// Does the even half-edge of a run's edge go along the line? True for a face.
  bool is_along(std::uint32_t run) const { return along_[run] != 0; }
  /// Of the line, in a face's plane.
  Direction direction(PlaneId plane) const;
  FaceId face(RowSide side) const { return face_[side]; }
  PlaneId plane(RowSide side) const;

  /// Counter-clockwise; those of one direction follow each other.
  std::uint32_t position(RowSide side) const { return position_[side]; }
  RowSide at(std::uint32_t position) const { return side_at_[position]; }
  /// Of the direction of what is at a position: its first position, and the one behind its last.
  std::uint32_t first(std::uint32_t position) const { return first_[position]; }
  std::uint32_t behind(std::uint32_t position) const { return behind_[position]; }

 private:
  void find_faces();
  bool runs_along(const Row::Run& run) const;
  void sort();

  const Workspace& w_;
  const Row& row_;
  PlaneId line_[2];  // two planes through it
  int axis_;         // on which it has an extent, and its sign there
  Sign up_;
  std::vector<std::uint8_t> along_;            // per run
  std::vector<FaceId> face_;                   // per side
  std::vector<std::uint32_t> position_;        // per side
  std::vector<RowSide> side_at_;               // per position
  std::vector<std::uint32_t> first_, behind_;  // per position
};

}  // namespace sectile
