#include "boolean/reduction/swept_rows.h"

#include <algorithm>
#include <functional>
#include <tuple>

#include "search/bucket_sort.h"

namespace sectile {

EdgeId edge_of_a(std::span<const SegmentRecord> records) {
  return records[0].on[Operand::a].edge();
}

std::vector<PlaceId> ends_of(std::span<const SegmentRecord> records) {
  std::vector<PlaceId> ends;
  for (const SegmentRecord& r : records) ends.insert(ends.end(), {r.place[0], r.place[1]});
  return ends;
}

SweptRows::SweptRows(const Workspace& w, Contacts& found) : w_(w), found_(found) {
  if (!may_be_swept(w)) return;
  struct Met {
    EdgeId edge;
    PlaceId place;
    auto operator<=>(const Met&) const = default;
  };
  for (const Operand s : both_operands) {
    const std::size_t edges = w.patch[s].brep.edge_count();
    is_in_face_[s].assign(edges, 0);
    for (const SegmentRecord& r : found.segments)
      if (r.on[s].is_edge() && r.on[other(s)].is_face()) is_in_face_[s][r.on[s].edge()] = 1;
    std::vector<Met> met;
    for (const Contact& c : found.contacts)
      if (c.on[s].is_edge()) met.push_back({c.on[s].edge(), c.place});
    first_met_[s] = bucket_sort(
        met, edges, [](const Met& m) { return m.edge.value(); }, std::less<>());
    for (const Met& m : met) met_[s].push_back(m.place);
  }
}

std::span<const PlaceId> SweptRows::met(Operand s, EdgeId edge) const {
  const std::uint32_t from = first_met_[s][edge.value()], to = first_met_[s][edge.value() + 1];
  return std::span(met_[s]).subspan(from, to - from);
}

bool SweptRows::add(std::span<const SegmentRecord> records) {
  if (!can_be_swept(records)) return false;
  const PlacesAlong places(w_, found_, edge_of_a(records), all_places(records));
  Row row;
  row.places.assign(places.in_order().begin(), places.in_order().end());
  for (const Operand s : both_operands) add_runs(s, records, places, row);
  if (!faces_keep_apart(row)) return false;
  add_meetings(places, row);
  found_.rows.push_back(std::move(row));
  return true;
}

std::vector<PlaceId> SweptRows::all_places(std::span<const SegmentRecord> records) const {
  std::vector<PlaceId> all = ends_of(records);
  for (const Operand s : both_operands) {
    std::vector<EdgeId> edges;
    for (const SegmentRecord& r : records) edges.push_back(r.on[s].edge());
    std::ranges::sort(edges);
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    for (const EdgeId e : edges) {
      const std::span<const PlaceId> here = met(s, e);
      all.insert(all.end(), here.begin(), here.end());
    }
  }
  return all;
}

bool SweptRows::can_be_swept(std::span<const SegmentRecord> records) const {
  return std::ranges::none_of(records, [&](const SegmentRecord& r) {
    return is_in_face_[Operand::a][r.on[Operand::a].edge()] != 0 ||
           is_in_face_[Operand::b][r.on[Operand::b].edge()] != 0;
  });
}

// Records of an edge beside others that overlap or follow each other make one run.
void SweptRows::add_runs(Operand s, std::span<const SegmentRecord> records,
                         const PlacesAlong& places, Row& row) const {
  std::vector<Row::Run> all;
  for (const SegmentRecord& r : records) {
    Row::Run run{s,
                 r.on[s].edge(),
                 places.number(r.place[0]),
                 places.number(r.place[1]),
                 {r.end[s][0], r.end[s][1]}};
    if (run.from > run.to) {
      std::swap(run.from, run.to);
      std::swap(run.end[0], run.end[1]);
    }
    all.push_back(run);
  }
  std::ranges::sort(all, [](const Row::Run& p, const Row::Run& q) {
    return std::tie(p.edge, p.from, p.to) < std::tie(q.edge, q.from, q.to);
  });
  const std::size_t first = row.runs.size();
  for (const Row::Run& run : all) {
    Row::Run* last = row.runs.size() > first ? &row.runs.back() : nullptr;
    if (!last || last->edge != run.edge || last->to < run.from) {
      row.runs.push_back(run);
    } else if (last->to < run.to) {
      last->to = run.to;
      last->end[1] = run.end[1];
    }
  }
}

void SweptRows::add_meetings(const PlacesAlong& places, Row& row) const {
  for (std::uint32_t i = 0; i < row.runs.size(); ++i) {
    const Row::Run& run = row.runs[i];
    for (const PlaceId place : met(run.operand, run.edge)) {
      const std::uint32_t at = places.number(place);
      if (run.from < at && at < run.to) row.meetings.push_back({at, i});
    }
  }
}

bool SweptRows::faces_keep_apart(const Row& row) const {
  struct Beside {
    Operand operand;
    FaceId face;
    std::uint32_t from, to;
    auto operator<=>(const Beside&) const = default;
  };
  std::vector<Beside> all;
  for (const Row::Run& run : row.runs)
    for (const unsigned side : {0u, 1u}) {
      const FaceId face = w_.patch[run.operand].brep.face_of(Brep::half_edge(run.edge, side));
      all.push_back({run.operand, face, run.from, run.to});
    }
  std::ranges::sort(all);
  return std::ranges::adjacent_find(all, [](const Beside& p, const Beside& q) {
           return p.operand == q.operand && p.face == q.face && q.from < p.to;
         }) == all.end();
}

}  // namespace sectile
