// Edges of a solid in faces of the other one, and which of them come near another face of the
// first.
#pragma once

#include <span>
#include <vector>

#include "boolean/reduction/contact_table.h"
#include "search/edge_fans.h"
#include "search/piece_tree.h"

namespace sectile {

/// The segments of edges of solid s in faces of the other one, by these faces. Where very many
/// begin in a corner of a face that is flush with that, directions tell which of them come into it.
class EdgesInFaces {
 public:
  EdgesInFaces(const Workspace& w, const Contacts& found, std::span<const PairOfFaces> flush,
               Operand s);

  /// The records in one face.
  struct Group {
    FaceId face;
    std::span<const std::uint32_t> records;
    EdgeFans fans;
    std::vector<std::vector<std::uint32_t>> of_fan;  ///< records of each; at last, of none
    std::vector<PieceTree> trees;                    ///< over these, or over all without fans
    BoxTree boxes;                                   ///< around them, if there are fans
  };
  /// What is in the face of the other solid (null if nothing), and the fans around corners of the
  /// face of s, ascending.
  struct Beside {
    const Group* group;
    std::vector<std::uint32_t> fans;
  };
  Beside beside(const PairOfFaces& pair) const;

  /// Adds the records that come near a polygon, but not those of the fans.
  void add_near(const Beside& beside, std::span<const Vec3> polygon,
                std::vector<std::uint32_t>& found) const;
  /// Adds those of fans around corners of the face of s that come into it.
  void add_from_corners(std::size_t pair, std::vector<std::uint32_t>& found) const;

 private:
  struct FromCorner {
    std::uint32_t pair, record;
    friend auto operator<=>(const FromCorner&, const FromCorner&) = default;
  };

  void make_group(std::span<const std::uint32_t> records);
  void divide_by_fans(Group& group) const;
  PieceTree tree_of(std::span<const std::uint32_t> records) const;
  void find_from_corners(std::span<const PairOfFaces> flush);
  const Group* find(FaceId in) const;
  FaceId face(std::uint32_t record) const { return found_.segments[record].on[other(s_)].face(); }
  std::uint32_t end(std::uint32_t record, int which) const;
  const Vec3& place(std::uint32_t record, int which) const;
  SeenArc arc_of_face(FaceId f, std::uint32_t corner) const;
  SeenArc arc_of_edge(std::uint32_t record, std::uint32_t corner) const;

  const Workspace& w_;
  const Contacts& found_;
  Operand s_;
  std::vector<std::uint32_t> order_;
  std::vector<Group> groups_;
  std::vector<FromCorner> from_corners_;  // ascending
};

}  // namespace sectile
