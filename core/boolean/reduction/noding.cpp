// Operands may touch themselves where their structure does not say so: an edge that lies on a face,
// or on a part of another edge. All entities through a contact place must end their segments there.
#include <algorithm>

#include "boolean/collect.h"
#include "boolean/line.h"
#include "boolean/reduction/contact_table.h"

namespace sectile {
namespace {

class Noding {
 public:
  Noding(const Workspace& w, const Contacts& found) : w_(w), kernel_(w.tests()), found_(found) {
    std::vector<Box> boxes(found.places.size());
    for (const PlaceId place : found.places.ids()) {
      Bounds bounds;
      bounds.add(w.geometry.position(found.point(place)));
      boxes[place.value()] = bounds.box();
    }
    tree_ = BoxTree(boxes);
  }

  void split(const SegmentRecord& record, std::vector<SegmentRecord>& out) const {
    std::vector<PlaceId> inside = places_inside(record);
    if (inside.empty()) {
      out.push_back(record);
      return;
    }
    PlaceId from = record.place[0];
    PerOperand<Entity> start{record.end[Operand::a][0], record.end[Operand::b][0]};
    inside.push_back(record.place[1]);
    for (const PlaceId to : inside) {
      SegmentRecord piece = record;
      const bool last = to == record.place[1];
      piece.place[0] = from;
      piece.place[1] = to;
      for (const Operand s : both_operands) {
        piece.end[s][0] = start[s];
        piece.end[s][1] = last ? record.end[s][1] : record.on[s];
        start[s] = record.on[s];
      }
      if (piece.place[0] > piece.place[1]) {
        std::swap(piece.place[0], piece.place[1]);
        for (auto& end : piece.end) std::swap(end[0], end[1]);
      }
      out.push_back(piece);
      from = to;
    }
  }

 private:
  std::pair<PlaneId, PlaneId> line_of(const SegmentRecord& record) const {
    for (const Operand s : both_operands)
      if (record.on[s].is_edge())
        return line_planes(w_.patch[s], Brep::half_edge(record.on[s].edge()));
    return {w_.patch[Operand::a].plane(record.on[Operand::a].face()),
            w_.patch[Operand::b].plane(record.on[Operand::b].face())};
  }

  // Those strictly between the two ends, in order.
  std::vector<PlaceId> places_inside(const SegmentRecord& record) const {
    const PointId p = found_.point(record.place[0]), q = found_.point(record.place[1]);
    Bounds bounds;
    bounds.add(w_.geometry.position(p));
    bounds.add(w_.geometry.position(q));
    const Box box = bounds.box();
    const auto [a, b] = line_of(record);
    std::vector<PlaceId> found;
    tree_.query([&](const Box& place) { return place.overlaps(box); },
                [&, a = a, b = b](std::uint32_t item) {
                  const PlaceId place{item};
                  if (place == record.place[0] || place == record.place[1]) return;
                  const PointId x = found_.point(place);
                  if (kernel_.side(x, a) == Sign::zero && kernel_.side(x, b) == Sign::zero)
                    found.push_back(place);
                });
    if (found.empty()) return found;
    const int axis = kernel_.cross_axis(a, b);
    const Sign along = kernel_.compare(p, q, axis);
    std::erase_if(found, [&](PlaceId place) {
      return kernel_.compare(p, found_.point(place), axis) != along ||
             kernel_.compare(found_.point(place), q, axis) != along;
    });
    std::sort(found.begin(), found.end(), [&](PlaceId i, PlaceId j) {
      return kernel_.compare(found_.point(i), found_.point(j), axis) == along;
    });
    return found;
  }

  const Workspace& w_;
  const Kernel& kernel_;
  const Contacts& found_;
  BoxTree tree_;
};

}  // namespace

void split_at_places(const Workspace& w, Contacts& found) {
  const Noding noding(w, found);
  using Records = std::vector<SegmentRecord>;
  Records pieces;
  for (const Records& r :
       collect<Records>(w, found.segments.size(), 128,
                        [&](std::size_t i, Records&out) { noding.split(found.segments[i], out); }))
    append(pieces, r);
  found.segments = std::move(pieces);
}

}  // namespace sectile
