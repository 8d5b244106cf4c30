// The row of one line, of what runs along it.
#pragma once

#include <span>
#include <vector>

#include "boolean/reduction/on_line.h"
#include "boolean/reduction/places_by_point.h"

namespace sectile {

class RowMaker {
 public:
  RowMaker(Workspace& w, Contacts& found, PlacesByPoint& places, const AlongLineOfPoints& along)
      : w_(w), found_(found), places_(places), along_(along) {}

  /// Adds places.
  Row run(std::span<const OnLine> all, std::span<const Crossed> crossed);

 private:
  // Where something ends or is met.
  struct Node {
    PointId point;
    Operand operand;
    Entity end;
  };

  void add_nodes(const OnLine& piece);
  void add_places();
  void add_place(std::span<const Node> nodes);
  void add_run(const OnLine& piece);
  void add_crossings(std::span<const Crossed> crossed);
  std::uint32_t number(PointId point) const;

  Workspace& w_;
  Contacts& found_;
  PlacesByPoint& places_;
  const AlongLineOfPoints& along_;
  std::vector<Node> nodes_;
  Row row_;
};

}  // namespace sectile
