#include "boolean/near/common_hubs.h"

#include <algorithm>
#include <tuple>

#include "boolean/collect.h"
#include "search/arc_partition.h"

namespace sectile {
namespace {

struct TooMany {};

bool same_point(const Geometry& a, PointId p, const Geometry& b, PointId q) {
  if (!(a.position(p) == b.position(q))) return false;
  if (a.is_explicit(p) && b.is_explicit(q)) return true;
  Geometry both;
  const PointId mine = load_point(a, p, both), across = load_point(b, q, both);
  return Kernel(both).same_point(mine, across);
}

}  // namespace

CommonHubs::CommonHubs(const SolidData& a, const SolidData& b,
                       const PerOperand<std::span<const std::uint32_t>>& slots,
                       const CommonFaces& left_out)
    : data_{&a, &b}, left_out_(left_out) {
  for (const Operand s : both_operands) {
    first_[s].resize(data_[s]->slots().size());
    for (const std::uint32_t slot : slots[s]) {
      const std::size_t count = hubs(s, slot).size();
      first_[s][slot] = static_cast<std::uint32_t>(fan_[s].size());
      for (std::uint32_t h = 0; h < count; ++h) order_.push_back({s, slot, h});
      fan_[s].resize(fan_[s].size() + count);
    }
  }
  if (fan_[Operand::a].empty() || fan_[Operand::b].empty()) order_.clear();
  number_places();
  find_lines();
  std::stable_sort(order_.begin(), order_.end(),
                   [&](const Hub& g, const Hub& h) { return fan_of(g) < fan_of(h); });
}

void CommonHubs::number_places() {
  std::sort(order_.begin(), order_.end(), [&](const Hub& g, const Hub& h) {
    const Vec3 &p = position(g), &q = position(h);
    return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
  });
  for (std::size_t i = 0; i < order_.size(); ++i) {
    std::size_t j = i;
    while (j > 0 && position(order_[j - 1]) == position(order_[i]) &&
           !are_at_one_place(order_[j - 1], order_[i]))
      --j;
    const bool known = j > 0 && position(order_[j - 1]) == position(order_[i]);
    fan_of(order_[i]) = known ? fan_of(order_[j - 1]) : static_cast<std::uint32_t>(i);
  }
}

// By the numbers of places. Many blocks have a part of one spine.
std::vector<Hubs::Spine> CommonHubs::spines_between_places() const {
  std::vector<Hubs::Spine> all;
  for (const Hub& h : order_)
    for (const Hubs::Spine& spine : hubs(h.solid, h.slot).spines())
      if (spine.from == h.number)
        all.push_back(Hubs::Spine::between(fan_of(h), fan_of({h.solid, h.slot, spine.to})));
  return Hubs::spines_among(std::move(all), 1);
}

void CommonHubs::find_lines() {
  const std::vector<Hubs::Spine> spines = spines_between_places();
  if (spines.empty()) return;
  Geometry geometry;
  std::vector<PointId> points;
  for (const Hub& h : order_) points.push_back(load_point(block(h).geometry(), point(h), geometry));
  lines_ = SpineLines(Kernel(geometry), points, spines);
  for (const Hub& h : order_)
    if (const std::uint32_t line = lines_.first_of_point(fan_of(h)); line != SpineLines::none)
      fan_of(h) = static_cast<std::uint32_t>(order_.size()) + line;
}

bool CommonHubs::are_at_one_place(const Hub& g, const Hub& h) const {
  return same_point(block(g).geometry(), point(g), block(h).geometry(), point(h));
}

std::vector<Box> CommonHubs::boxes_along_line(const Hub& h, std::uint32_t fan) const {
  const Brep& brep = block(h).brep();
  const Geometry& geometry = block(h).geometry();
  const Hubs& of_block = hubs(h.solid, h.slot);
  std::vector<PointId> known;  // on the line
  for (std::uint32_t i = 0; i < of_block.size(); ++i)
    if (fan_of({h.solid, h.slot, i}) == fan) known.push_back(of_block.point(i));
  std::vector<Box> boxes;
  std::vector<Vec3> on_line, beside;
  for (const FaceId f : of_block.faces(h.number)) {
    on_line.clear();
    beside.clear();
    for_each_in_loop(brep, brep.outer_loop[f], [&](HalfEdgeId e) {
      const PointId p = brep.point_of(brep.from(e));
      (std::ranges::find(known, p) != known.end() ? on_line : beside)
          .push_back(geometry.position(p));
    });
    boxes.push_back(lines_[fan - static_cast<std::uint32_t>(order_.size())].box(on_line, beside));
  }
  return boxes;
}

void CommonHubs::add_faces(const Hub& h, std::uint32_t fan, Fan& to) const {
  const std::span<const FaceId> faces = hubs(h.solid, h.slot).faces(h.number);
  std::vector<SeenArc> arcs;
  std::vector<Box> boxes;
  if (fan < order_.size())
    arcs = arcs_seen_from(point(h), block(h).brep(), block(h).geometry(), faces);
  else
    boxes = boxes_along_line(h, fan);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (left_out_.has(h.solid, h.slot, faces[i])) continue;
    to.faces.push_back(data_[h.solid]->face(h.slot, faces[i]));
    if (!arcs.empty()) to.arcs.push_back(arcs[i]);
    if (!boxes.empty()) to.boxes.push_back(boxes[i]);
  }
}

// Calls visit(CommonFan) for what both solids have.
template <class Visit>
void CommonHubs::for_each_fan(const Visit& visit) const {
  for (std::size_t from = 0, to; from < order_.size(); from = to) {
    CommonFan common;
    const std::uint32_t fan = fan_of(order_[from]);
    for (to = from; to < order_.size() && fan_of(order_[to]) == fan; ++to) {
      const Hub& h = order_[to];
      add_faces(h, fan, common.of[h.solid]);
      if (common.places.empty() || !(common.places.back() == position(h)))
        common.places.push_back(position(h));
    }
    if (fan >= order_.size())
      common.line = &lines_[fan - static_cast<std::uint32_t>(order_.size())];
    if (!common.of[Operand::a].faces.empty() && !common.of[Operand::b].faces.empty()) visit(common);
  }
}

CommonFaces::Faces CommonHubs::left_out_on_lines() const {
  CommonFaces::Faces faces;
  if (left_out_.empty()) return faces;
  for (const Hub& h : order_) {
    if (fan_of(h) < order_.size()) continue;
    for (const FaceId f : hubs(h.solid, h.slot).faces(h.number))
      if (left_out_.has(h.solid, h.slot, f))
        faces.push_back({h.solid, data_[h.solid]->face(h.slot, f)});
  }
  return faces;
}

bool CommonHubs::add_pairs(FacePairs& pairs, std::size_t most) const try {
  for_each_fan([&](const CommonFan& fan) {
    const Fan &a = fan.of[Operand::a], &b = fan.of[Operand::b];
    const auto add = [&](std::uint32_t i, std::uint32_t j) {
      if (pairs.size() == most) throw TooMany();
      pairs.push_back({a.faces[i], b.faces[j]});
    };
    if (fan.line)
      BoxTree::overlaps(BoxTree(a.boxes), BoxTree(b.boxes), add);
    else
      for_each_pair_of_arcs(a.arcs, b.arcs, add);
  });
  return true;
} catch (const TooMany&) {
  return false;
}

PerOperand<std::vector<FaceId>> CommonHubs::faces() const {
  PerOperand<std::vector<FaceId>> faces;
  for_each_fan([&](const CommonFan& fan) {
    for (const Operand s : both_operands) append(faces[s], fan.of[s].faces);
  });
  return faces;
}

void CommonHubs::add_pairs_of_owners(Workspace& w, FacePairs& pairs) const {
  for_each_fan([&](const CommonFan& fan) {
    append(pairs, pairs_of_owners(w, Operand::a, fan));
    for (const auto& [g, f] : pairs_of_owners(w, Operand::b, fan)) pairs.push_back({f, g});
  });
}

}  // namespace sectile
