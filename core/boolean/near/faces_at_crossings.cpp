#include "boolean/near/faces_at_crossings.h"

#include <algorithm>

namespace sectile {

FacesAtCrossings::FacesAtCrossings(std::span<const LineCrossing> crossings, std::size_t lines)
    : crossings_(crossings), faces_(crossings.size()), with_(lines) {
  for (std::uint32_t i = 0; i < crossings.size(); ++i) {
    const auto [line, other] = crossings[i].line;
    with_[line].push_back({other, i});
    with_[other].push_back({line, i});
  }
  for (auto& of_line : with_) {
    std::ranges::sort(of_line);
    std::vector<Box> boxes;
    for (const With& with : of_line) {
      const Vec3& place = crossings[with.crossing].place;
      boxes.push_back(box_around(place, place));
    }
    places_.emplace_back(boxes);
  }
}

std::uint32_t FacesAtCrossings::add(Operand s, std::uint32_t face, std::uint32_t line,
                                    const Box& box) {
  Group group{line, reached(line, box)};
  for (const std::uint32_t c : group.crossings)
    faces_[c][line == crossings_[c].line[0] ? 0 : 1][s].push_back(face);
  return number(std::move(group));
}

std::vector<std::uint32_t> FacesAtCrossings::reached(std::uint32_t line, const Box& box) const {
  std::vector<std::uint32_t> crossings;
  places_[line].query([&](const Box& place) { return place.overlaps(box); },
                      [&](std::uint32_t i) { crossings.push_back(with_[line][i].crossing); });
  std::ranges::sort(crossings);
  return crossings;
}

std::uint32_t FacesAtCrossings::number(Group group) {
  const auto [at, is_new] = numbers_.try_emplace(group, static_cast<std::uint32_t>(groups_.size()));
  if (is_new) groups_.push_back(std::move(group));
  return at->second;
}

bool FacesAtCrossings::are_at_one_place(std::uint32_t group, std::uint32_t other) const {
  const Group &g = groups_[group], &h = groups_[other];
  if (g.line == h.line) return true;
  if (g.crossings.empty() || h.crossings.empty()) return false;
  const auto with = std::ranges::lower_bound(with_[g.line], h.line, {}, &With::line);
  return with != with_[g.line].end() && with->line == h.line &&
         std::ranges::binary_search(g.crossings, with->crossing) &&
         std::ranges::binary_search(h.crossings, with->crossing);
}

}  // namespace sectile
