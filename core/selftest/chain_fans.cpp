#include "selftest/chain_fans.h"

#include <algorithm>
#include <array>

#include "numbers/threshold.h"
#include "search/along_line.h"
#include "search/arc_partition.h"
#include "search/box_tree.h"
#include "search/edge_chains.h"
#include "search/seen_arc.h"
#include "selftest/edges_on_line.h"

namespace sectile {
namespace {

// In so many corners a chain is bent: else there are few lines on which its edges are.
constexpr std::size_t least_bends = threshold(8, 1);

Box box_of(const TriangleSurface& surface, const Geometry& geometry, std::uint32_t t) {
  Bounds bounds;
  for (const PointId p : surface.corners[t]) bounds.add(geometry.position(p));
  return bounds.box();
}

}  // namespace

std::span<const ChainFans::Wing> ChainFans::wings_at(const Fan& fan, std::int64_t first_edge,
                                                     std::int64_t end) {
  const auto by_edge = [](const Wing& w) { return std::int64_t(w.edge); };
  return {std::ranges::lower_bound(fan.wings, first_edge, {}, by_edge),
          std::ranges::lower_bound(fan.wings, end, {}, by_edge)};
}

// What is seen from a corner of the chain: wings that have their apex in common and are on one side
// of it, and spikes. Two of these that are seen in different directions have no more than the
// corner in common: what holds it otherwise than as a corner is seen in so many that it is no arc.
// Those on one side are looked at from another corner, and those that have an apex in common from
// there.
class ChainFans::View {
 public:
  View(const Fan& fan, std::int64_t at, const TriangleSurface& surface, const Geometry& geometry)
      : fan_(fan), at_(at), surface_(surface), geometry_(geometry) {}

  void add_wings(std::int64_t first_edge, std::int64_t end, std::uint32_t side) {
    const std::span<const Wing> there = wings_at(fan_, first_edge, end);
    std::vector<Wing> wings(there.begin(), there.end());
    std::ranges::stable_sort(wings, {}, &Wing::apex);
    for (auto first = wings.begin(), last = first; first != wings.end(); first = last) {
      while (last != wings.end() && last->apex == first->apex) ++last;
      add({first, last}, side);
    }
  }
  // At corners between two others.
  void add_spikes(std::int64_t after, std::int64_t before, std::uint32_t side) {
    const auto by_corner = [](const Spike& s) { return std::int64_t(s.at); };
    const auto from = std::ranges::upper_bound(fan_.spikes, after, {}, by_corner),
               to = std::ranges::lower_bound(fan_.spikes, before, {}, by_corner);
    for (auto spike = from; spike < to; ++spike) add_spike(spike->triangle, side);
  }

  void for_each_pair(const Visit& visit) const {
    ArcPartition(arcs_, sides_).for_each_pair([&](std::uint32_t i, std::uint32_t j) {
      if (!apexes_[i].valid() || apexes_[i] != apexes_[j]) visit_all(i, j, visit);
    });
  }

 private:
  PointId point(std::int64_t corner) const {
    return PointId(fan_.chain[static_cast<std::size_t>(corner)]);
  }
  const Vec3& position(std::int64_t corner) const { return geometry_.position(point(corner)); }
  std::span<const std::uint32_t> triangles(std::uint32_t unit) const {
    return std::span(triangles_).subspan(first_[unit], first_[unit + 1] - first_[unit]);
  }

  void add(std::span<const Wing> wings, std::uint32_t side) {
    others_.clear();
    others_.push_back(geometry_.position(wings[0].apex));
    std::int64_t next = 0;  // corner of the chain
    for (const Wing& w : wings) {
      triangles_.push_back(w.triangle);
      for (next = std::max(next, std::int64_t(w.edge)); next <= w.edge + 1; ++next)
        if (next != at_) others_.push_back(position(next));
    }
    end_unit(wings[0].apex, side);
  }
  void add_spike(std::uint32_t triangle, std::uint32_t side) {
    triangles_.push_back(triangle);
    others_.clear();
    for (const PointId p : surface_.corners[triangle])
      if (p != point(at_)) others_.push_back(geometry_.position(p));
    end_unit(PointId(), side);
  }
  void end_unit(PointId apex, std::uint32_t side) {
    arcs_.push_back(SeenArc::from_point(position(at_), others_));
    sides_.push_back(side);
    apexes_.push_back(apex);
    first_.push_back(static_cast<std::uint32_t>(triangles_.size()));
  }

  void visit_all(std::uint32_t i, std::uint32_t j, const Visit& visit) const {
    const std::span<const std::uint32_t> few = triangles(i), others = triangles(j);
    std::vector<Box> boxes;
    for (const std::uint32_t t : others) boxes.push_back(box_of(surface_, geometry_, t));
    for (const std::uint32_t s : few) {
      const Box box = box_of(surface_, geometry_, s);
      for (std::size_t k = 0; k < others.size(); ++k)
        if (boxes[k].overlaps(box)) visit(s, others[k]);
    }
  }

  const Fan& fan_;
  std::int64_t at_;
  const TriangleSurface& surface_;
  const Geometry& geometry_;
  std::vector<SeenArc> arcs_;
  std::vector<std::uint32_t> sides_;  // per arc, as labels
  std::vector<PointId> apexes_;       // of wings; none of spikes
  std::vector<std::uint32_t> triangles_, first_{0};
  std::vector<Vec3> others_;
};

ChainFans::ChainFans(const TriangleSurface& surface, const Kernel& kernel,
                     std::span<const std::uint32_t> triangles, std::span<const PointPair> edges)
    : surface_(surface), kernel_(kernel) {
  if (edges.size() <= least_bends) return;
  for (std::vector<std::uint32_t>& chain : edge_chains(edges))
    if (chain.front() != chain.back() && is_bent(chain))
      fans_.push_back({std::move(chain), {}, {}, {}, {}});
  if (fans_.empty()) return;
  gather(triangles);
  for (std::uint32_t fan = 0; fan < fans_.size(); ++fan) add_parts(fan);
}

bool ChainFans::is_bent(std::span<const std::uint32_t> chain) const {
  std::size_t bends = 0;
  for (std::size_t i = 2; i < chain.size() && bends < least_bends; ++i)
    bends +=
        are_on_one_line(kernel_, PointId(chain[i - 2]), PointId(chain[i - 1]), PointId(chain[i]))
            ? 0
            : 1;
  return bends >= least_bends;
}

// Each triangle is in the fan of the chain that has most of its corners.
void ChainFans::gather(std::span<const std::uint32_t> triangles) {
  struct Place {
    std::uint32_t point, fan, at;
  };
  std::vector<Place> places;
  for (std::uint32_t fan = 0; fan < fans_.size(); ++fan)
    for (std::uint32_t at = 0; at < fans_[fan].chain.size(); ++at)
      places.push_back({fans_[fan].chain[at], fan, at});
  std::ranges::sort(places, {}, &Place::point);
  of_triangle_.assign(surface_.size(), none);
  std::vector<Place> here;
  std::vector<std::uint32_t> of_fan;
  for (const std::uint32_t t : triangles) {
    here.clear();
    for (const PointId p : surface_.corners[t])
      for (auto place = std::ranges::lower_bound(places, p.value(), {}, &Place::point);
           place != places.end() && place->point == p.value(); ++place)
        here.push_back(*place);
    if (here.empty()) continue;
    const auto on_chain_of = [&](const Place& p) {
      return std::ranges::count(here, p.fan, &Place::fan);
    };
    const std::uint32_t fan = std::ranges::max_element(here, {}, on_chain_of)->fan;
    of_fan.clear();
    for (const Place& p : here)
      if (p.fan == fan) of_fan.push_back(p.at);
    std::ranges::sort(of_fan);
    add(t, fan, of_fan);
  }
}

void ChainFans::add(std::uint32_t t, std::uint32_t number, std::span<const std::uint32_t> places) {
  of_triangle_[t] = number;
  Fan& fan = fans_[number];
  if (places.size() == 1) {
    fan.spikes.push_back({t, places[0]});
  } else if (places.size() == 2 && places[1] == places[0] + 1) {
    PointId apex;
    for (const PointId p : surface_.corners[t])
      if (p.value() != fan.chain[places[0]] && p.value() != fan.chain[places[1]]) apex = p;
    fan.wings.push_back({t, places[0], apex});
  } else {
    fan.others.push_back(t);
  }
}

void ChainFans::add_parts(std::uint32_t number) {
  Fan& fan = fans_[number];
  fan.by_apex = fan.wings;
  std::ranges::stable_sort(fan.wings, {}, &Wing::edge);
  std::ranges::stable_sort(fan.by_apex, {}, &Wing::apex);
  std::ranges::stable_sort(fan.spikes, {}, &Spike::at);
  const auto last = static_cast<std::int64_t>(fan.chain.size()) - 1;
  parts_.push_back({Part::Kind::middle, number, 0, last, 0});
  parts_.push_back({Part::Kind::middle, number, -1, last, last});
  halve(number, 0, last);
  for (std::int64_t edge = 0; edge < last; ++edge)
    parts_.push_back({Part::Kind::edge, number, edge, edge + 1, 0});
  const auto& wings = fan.by_apex;
  for (std::size_t from = 0, to; from < wings.size(); from = to) {
    for (to = from; to < wings.size() && wings[to].apex == wings[from].apex;) ++to;
    if (to - from > 1)
      parts_.push_back({Part::Kind::apex, number, std::int64_t(from), std::int64_t(to), 0});
  }
  if (!fan.others.empty()) parts_.push_back({Part::Kind::others, number, 0, last, 0});
}

void ChainFans::halve(std::uint32_t fan, std::int64_t low, std::int64_t high) {
  if (high - low < 2) return;
  const std::int64_t middle = (low + high) / 2;
  parts_.push_back({Part::Kind::middle, fan, low, high, middle});
  halve(fan, low, middle);
  halve(fan, middle, high);
}

void ChainFans::for_each_pair(std::size_t number, const Visit& visit) const {
  const Part& part = parts_[number];
  switch (part.kind) {
    case Part::Kind::middle:
      return look_from(part, visit);
    case Part::Kind::edge:
      return look_along(part, visit);
    case Part::Kind::apex:
      return look_from_apex(part, visit);
    case Part::Kind::others:
      return look_at_others(part, visit);
  }
}

void ChainFans::look_from(const Part& part, const Visit& visit) const {
  View view(fans_[part.fan], part.at, surface_, kernel_.geometry());
  view.add_wings(part.low, part.at, 0);
  view.add_spikes(part.low, part.at, 0);
  view.add_wings(part.at, part.high, 1);
  view.add_spikes(part.at, part.high, 1);
  view.add_spikes(part.at - 1, part.at + 1, SpacePartition::no_label);
  view.for_each_pair(visit);
}

// Those at one edge.
void ChainFans::look_along(const Part& part, const Visit& visit) const {
  const Fan& fan = fans_[part.fan];
  const auto edge = static_cast<std::size_t>(part.low);
  const std::span<const Wing> wings = wings_at(fan, part.low, part.high);
  if (wings.size() < 2) return;
  std::array<PointId, 2> ends{PointId(fan.chain[edge]), PointId(fan.chain[edge + 1])};
  if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
  const Geometry& geometry = kernel_.geometry();
  const std::array<Vec3, 2> on_line{geometry.position(ends[0]), geometry.position(ends[1])};
  const AlongLine line(on_line[0], on_line[1]);
  std::vector<std::uint32_t> triangles;
  std::vector<Box> boxes;
  for (const Wing& w : wings) {
    triangles.push_back(w.triangle);
    boxes.push_back(line.box(on_line, std::array{geometry.position(w.apex)}));
  }
  const BoxTree tree(boxes);
  for (const BoxTree::SelfPart& some : tree.self_parts(1))
    tree.self_overlaps(
        some, [&](std::uint32_t i, std::uint32_t j) { visit(triangles[i], triangles[j]); });
  if (EdgesOnLine(surface_, kernel_, triangles, ends).alternate()) return;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    for (std::size_t j = i + 1; j < boxes.size(); ++j)
      if (!boxes[i].overlaps(boxes[j])) visit(triangles[i], triangles[j]);
}

void ChainFans::look_from_apex(const Part& part, const Visit& visit) const {
  const Fan& fan = fans_[part.fan];
  const auto wings =
      std::span(fan.by_apex).subspan(std::size_t(part.low), std::size_t(part.high - part.low));
  const Geometry& geometry = kernel_.geometry();
  std::vector<SeenArc> arcs;
  for (const Wing& w : wings)
    arcs.push_back(SeenArc::from_point(
        geometry.position(w.apex), std::array{geometry.position(PointId(fan.chain[w.edge])),
                                              geometry.position(PointId(fan.chain[w.edge + 1]))}));
  ArcPartition(arcs).for_each_pair(
      [&](std::uint32_t i, std::uint32_t j) { visit(wings[i].triangle, wings[j].triangle); });
}

// Those that have corners here and there on the chain.
void ChainFans::look_at_others(const Part& part, const Visit& visit) const {
  const Fan& fan = fans_[part.fan];
  std::vector<std::uint32_t> triangles = fan.others;
  for (const Wing& w : fan.wings) triangles.push_back(w.triangle);
  for (const Spike& s : fan.spikes) triangles.push_back(s.triangle);
  std::vector<Box> boxes;
  boxes.reserve(triangles.size());
  for (const std::uint32_t t : triangles) boxes.push_back(box_of(surface_, kernel_.geometry(), t));
  const BoxTree tree(boxes);
  for (std::uint32_t other = 0; other < fan.others.size(); ++other)
    tree.query([&](const Box& box) { return box.overlaps(boxes[other]); },
               [&](std::uint32_t i) {
                 if (i > other) visit(triangles[other], triangles[i]);
               });
}

}  // namespace sectile
