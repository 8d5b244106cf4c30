// The segments in which two faces in different planes meet: the common line enters and leaves both
// of them at contacts.
#pragma once

#include <span>
#include <vector>

#include "boolean/reduction/contact_table.h"
#include "boolean/reduction/standing.h"

namespace sectile {

/// Appends the segments of one pair after the other. What it needs for a pair is kept for the next
/// one, for its memory.
class CrossingFaces {
 public:
  CrossingFaces(const Workspace& w, const Contacts& found, const ContactTable& table,
                SegmentRecords& out)
      : w_(w), kernel_(w.tests()), found_(found), table_(table), out_(out) {}

  void operator()(const PairOfFaces& pair);

 private:
  // Something of a face's boundary at a place on the common line.
  struct Item {
    PlaceId place;
    Operand solid;
    BoundaryItem of;
    friend auto operator<=>(const Item&, const Item&) = default;
  };
  struct Point {
    PlaceId place;
    PerOperand<std::span<const Item>> items;
  };
  struct EdgeOnLine {
    Operand solid;
    HalfEdgeId h;
  };
  // An edge of one face that pierces the interior of the other one.
  struct Piercing {
    Operand solid;
    EdgeId edge;
    PlaceId place;
    bool enters;  // does the line, in the direction of n(a) × n(b), enter the edge's face there?
  };

  bool cross_in_one_segment();
  bool find_piercings();
  void add(const Piercing& from, const Piercing& to);

  void cross_in_points();
  void gather(Operand s);
  void add(Operand s, Entity piercer, std::span<const Hit> hits, HalfEdgeId h);
  bool precedes(PointId p, PointId q) const;
  bool find_points();
  bool add_items_within();
  void between(const Point& p, const Point& q);
  Standing stands(Operand s, const Point& p, const Direction& direction);
  void emit(SegmentRecord record) {
    record.put_in_order();
    out_.push_back(record);
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& found_;
  const ContactTable& table_;
  SegmentRecords& out_;

  // Of the pair that is looked at.
  PairOfFaces pair_{};
  std::vector<Piercing> piercings_;
  std::vector<Item> items_;
  std::vector<Point> points_;
  std::vector<EdgeOnLine> edges_on_line_;
  std::vector<BoundaryItem> bounds_;
  Kernel::AxisSign line_{};
  PerOperand<Direction> direction_;
};

}  // namespace sectile
