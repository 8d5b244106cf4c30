#include "arrangement/edge_rows.h"

#include <algorithm>

#include "geometry/around_line.h"
#include "parallel/parallel.h"
#include "search/bucket_sort.h"
#include "search/circle.h"
#include "search/places_on_line.h"

namespace sectile::arrangement {
namespace {

// An edge of a sub-face.
struct Edge {
  std::uint32_t corner;
  PointId from, to;
};

// Per line; some may have none.
std::vector<std::vector<Edge>> edges_of_rows(const SubFaces& faces) {
  std::vector<std::vector<Edge>> edges;
  const Polygons& polygons = faces.polygons;
  for (std::uint32_t l = 0; l < polygons.loop_end.size(); ++l) {
    const std::uint32_t begin = polygons.loop_begin(l), end = polygons.loop_end[l];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t row = faces.row[c];
      if (row == none) continue;
      if (row >= edges.size()) edges.resize(row + 1);
      edges[row].push_back({c, polygons.corners[c], polygons.corners[c + 1 < end ? c + 1 : begin]});
    }
  }
  return edges;
}

class RowMaker {
 public:
  RowMaker(const SubFaces& faces, const std::vector<std::uint32_t>& face_of, const Kernel& kernel,
           const std::vector<Edge>& edges)
      : faces_(faces), face_of_(face_of), kernel_(kernel), places_(kernel, ends_of(edges)) {
    for (const Edge& e : edges) {
      const auto from = static_cast<std::uint32_t>(places_.of(e.from)),
                 to = static_cast<std::uint32_t>(places_.of(e.to));
      row_.sides.push_back({e.corner, from < to, std::min(from, to), std::max(from, to), 0});
    }
    for (std::size_t k = 0; k < places_.count(); ++k) row_.places.push_back(places_.at(k));
  }

  EdgeRow run() {
    const AroundLine around(kernel_, places_.axis(), Sign::positive);
    struct Placed {
      int quarter;
      LineSide half_plane;
      EdgeRow::Side side;
    };
    std::vector<Placed> all;
    const LineSide start = half_plane(row_.sides.front());
    for (const EdgeRow::Side& side : row_.sides)
      all.push_back({around.quarter(start, half_plane(side)), half_plane(side), side});
    std::sort(all.begin(), all.end(), [&](const Placed& p, const Placed& q) {
      if (p.quarter != q.quarter) return p.quarter < q.quarter;
      const Sign turn = around.turn(p.half_plane, q.half_plane);
      return turn != Sign::zero ? turn == Sign::positive : p.side.corner < q.side.corner;
    });
    for (std::uint32_t i = 0; i < all.size(); ++i) {
      row_.sides[i] = all[i].side;
      const bool same = i > 0 && all[i].quarter == all[i - 1].quarter &&
                        around.tied(all[i].half_plane, all[i - 1].half_plane);
      row_.sides[i].direction = same ? row_.sides[i - 1].direction : i;
    }
    return std::move(row_);
  }

 private:
  static std::vector<PointId> ends_of(const std::vector<Edge>& edges) {
    std::vector<PointId> ends;
    for (const Edge& e : edges) ends.insert(ends.end(), {e.from, e.to});
    std::sort(ends.begin(), ends.end());
    ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
    return ends;
  }

  LineSide half_plane(const EdgeRow::Side& side) const {
    return {faces_.plane[face_of_[side.corner]], side.forward};
  }

  const SubFaces& faces_;
  const std::vector<std::uint32_t>& face_of_;
  const Kernel& kernel_;
  const PlacesOnLine places_;
  EdgeRow row_;
};

// Goes along a row. At each place only sides that begin or end there, and those before them, get
// another neighbour.
class RowWalk {
 public:
  RowWalk(const EdgeRow& row, const std::vector<std::uint8_t>& marked)
      : row_(row), next_(row.sides.size(), none), since_(row.sides.size()) {
    for (std::uint32_t i = 0; i < row.sides.size(); ++i) {
      if (marked[i] == 0) continue;
      events_.push_back({row.sides[i].from, i});
      events_.push_back({row.sides[i].to, i});
    }
    first_ = bucket_sort(
        events_, row.places.size(), [](const Event& e) { return e.place; },
        [](const Event& a, const Event& b) { return a.side < b.side; });
  }

  std::vector<Neighbours> run() {
    for (std::uint32_t place = 0; place < row_.places.size(); ++place) visit(place);
    return std::move(found_);
  }

 private:
  struct Event {
    std::uint32_t place, side;
  };

  bool ends(const Event& e) const { return row_.sides[e.side].to == e.place; }

  void visit(std::uint32_t place) {
    const auto events =
        std::span<const Event>(events_).subspan(first_[place], first_[place + 1] - first_[place]);
    for (const Event& e : events)
      if (ends(e)) {
        present_.remove(e.side);
        set_next(e.side, none, place);
      }
    for (const Event& e : events)
      if (!ends(e)) present_.add(e.side);
    if (present_.empty()) return;
    for (const Event& e : events) {
      const std::uint32_t before = present_.before(e.side);
      set_next(before, present_.behind(before), place);
      if (!ends(e)) set_next(e.side, present_.behind(e.side), place);
    }
  }

  void set_next(std::uint32_t side, std::uint32_t next, std::uint32_t place) {
    if (next_[side] == next) return;
    if (next_[side] != none) found_.push_back({side, next_[side], since_[side], place});
    next_[side] = next;
    since_[side] = place;
  }

  const EdgeRow& row_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> first_;  // per place
  Circle present_;
  std::vector<std::uint32_t> next_, since_;  // per side
  std::vector<Neighbours> found_;
};

}  // namespace

std::vector<EdgeRow> find_rows(const SubFaces& faces, const std::vector<std::uint32_t>& face_of,
                               const Kernel& kernel) {
  if (faces.row.empty()) return {};
  std::vector<std::vector<Edge>> edges = edges_of_rows(faces);
  std::erase_if(edges, [](const std::vector<Edge>& of_row) { return of_row.empty(); });
  std::vector<EdgeRow> rows(edges.size());
  parallel::loop(0, rows.size(), [&](std::size_t i) {
    rows[i] = RowMaker(faces, face_of, kernel, edges[i]).run();
  });
  return rows;
}

std::vector<Neighbours> neighbours(const EdgeRow& row, const std::vector<std::uint8_t>& marked) {
  return RowWalk(row, marked).run();
}

}  // namespace sectile::arrangement
