#include "boolean/reduction/row_maker.h"

#include <algorithm>

namespace sectile {

Row RowMaker::run(std::span<const OnLine> all, std::span<const Crossed> crossed) {
  for (const OnLine& piece : all) add_nodes(piece);
  for (const Crossed& c : crossed) nodes_.push_back({c.point, c.operand, {}});
  add_places();
  for (const OnLine& piece : all) add_run(piece);
  if (!crossed.empty()) add_crossings(crossed);
  return std::move(row_);
}

void RowMaker::add_nodes(const OnLine& piece) {
  for (const auto& [point, entity] : piece.end)
    if (point.valid()) nodes_.push_back({point, piece.operand, entity});
  for (const PlaceId place : piece.met) nodes_.push_back({found_.point(place), piece.operand, {}});
}

// Nodes at one point are one place of the row, and of the contacts.
void RowMaker::add_places() {
  std::ranges::sort(nodes_, [&](const Node& p, const Node& q) {
    return along_.compare(p.point, q.point) == Sign::positive;
  });
  for (std::size_t from = 0, to; from < nodes_.size(); from = to) {
    for (to = from + 1;
         to < nodes_.size() && along_.compare(nodes_[from].point, nodes_[to].point) == Sign::zero;)
      ++to;
    add_place(std::span(nodes_).subspan(from, to - from));
  }
}

void RowMaker::add_place(std::span<const Node> nodes) {
  const PlaceId place = places_.find_or_add(nodes.front().point);
  for (const Node& node : nodes)
    if (node.end.is_vertex())
      w_.patch[node.operand].brep.point[node.end.vertex()] = found_.point(place);
  row_.places.push_back(place);
}

std::uint32_t RowMaker::number(PointId point) const {
  const auto at = std::ranges::partition_point(row_.places, [&](PlaceId place) {
    return along_.compare(found_.point(place), point) == Sign::positive;
  });
  return static_cast<std::uint32_t>(at - row_.places.begin());
}

void RowMaker::add_run(const OnLine& piece) {
  Row::Run run{piece.operand,
               piece.carrier,
               0,
               static_cast<std::uint32_t>(row_.places.size() - 1),
               {piece.end[0].entity, piece.end[1].entity}};
  if (piece.end[0].point.valid()) {
    run.from = number(piece.end[0].point);
    run.to = number(piece.end[1].point);
  }
  if (run.from > run.to) {
    std::swap(run.from, run.to);
    std::swap(run.end[0], run.end[1]);
  }
  const auto index = static_cast<std::uint32_t>(row_.runs.size());
  for (const PlaceId place : piece.met)
    row_.meetings.push_back({number(found_.point(place)), index});
  row_.runs.push_back(run);
}

// What is crossed is divided, and what of the other operand runs through the point. So is the
// segment that crosses, as the point is a place now.
void RowMaker::add_crossings(std::span<const Crossed> crossed) {
  struct Crossing {
    Operand operand;
    Entity carrier;
    std::uint32_t place;
    auto operator<=>(const Crossing&) const = default;
  };
  std::vector<Crossing> crossings;
  PerOperand<std::vector<std::uint32_t>> places;  // where one operand is crossed
  for (const Crossed& c : crossed) {
    crossings.push_back({c.operand, c.carrier, number(c.point)});
    places[c.operand].push_back(crossings.back().place);
  }
  std::ranges::sort(crossings);
  for (auto& of_operand : places) std::ranges::sort(of_operand);
  for (std::uint32_t i = 0; i < row_.runs.size(); ++i) {
    const Row::Run& run = row_.runs[i];
    const auto& by_it = places[other(run.operand)];
    for (auto at = std::ranges::upper_bound(by_it, run.from); at != by_it.end() && *at < run.to;)
      row_.meetings.push_back({*at++, i});
    const auto last =
        std::ranges::lower_bound(crossings, Crossing{run.operand, run.carrier, run.to});
    for (auto at =
             std::ranges::upper_bound(crossings, Crossing{run.operand, run.carrier, run.from});
         at < last;)
      row_.meetings.push_back({at++->place, i});
  }
}

}  // namespace sectile
