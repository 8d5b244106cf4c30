// Faces at crowded lines, by the crossings of these lines to which they may reach.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "boolean/near/line_crossings.h"
#include "boolean/operand.h"
#include "search/box_tree.h"

namespace sectile {

class FacesAtCrossings {
 public:
  FacesAtCrossings(std::span<const LineCrossing> crossings, std::size_t lines);

  /// Returns the face's group: faces of one group are at one line, and reach to the same crossings.
  std::uint32_t add(Operand s, std::uint32_t face, std::uint32_t line, const Box& box);
  /// Are two groups at one line, or do both reach to the crossing of their lines?
  bool are_at_one_place(std::uint32_t group, std::uint32_t other) const;

  /// Those that reach to a crossing, at each of its lines.
  using OfLines = std::array<PerOperand<std::vector<std::uint32_t>>, 2>;
  const OfLines& at(std::size_t crossing) const { return faces_[crossing]; }

 private:
  struct Group {
    std::uint32_t line;
    std::vector<std::uint32_t> crossings;  // ascending
    auto operator<=>(const Group&) const = default;
  };
  /// A crossing with another line.
  struct With {
    std::uint32_t line, crossing;
    auto operator<=>(const With&) const = default;
  };

  std::vector<std::uint32_t> reached(std::uint32_t line, const Box& box) const;
  std::uint32_t number(Group group);

  std::span<const LineCrossing> crossings_;
  std::vector<OfLines> faces_;           // per crossing
  std::vector<std::vector<With>> with_;  // per line
  std::vector<BoxTree> places_;          // per line, of these
  std::map<Group, std::uint32_t> numbers_;
  std::vector<Group> groups_;
};

}  // namespace sectile
