#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "boolean/reduction/reduction.h"

namespace sectile {

/// The segments of edges of solid s that are in faces of the other one, ordered by these faces.
inline std::vector<std::uint32_t> edges_by_faces(const Contacts& found, Operand s) {
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < found.segments.size(); ++i)
    if (found.segments[i].on[s].is_edge() && found.segments[i].on[other(s)].is_face())
      order.push_back(i);
  const auto face = [&](std::uint32_t i) { return found.segments[i].on[other(s)].face(); };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return face(i) < face(j); });
  return order;
}

}  // namespace sectile
