#include "boolean/reduction/places_along.h"

#include <algorithm>
#include <numeric>

#include "boolean/line.h"

namespace sectile {

PlacesAlong::PlacesAlong(const Workspace& w, const Contacts& found, EdgeId edge,
                         std::vector<PlaceId> places)
    : places_(std::move(places)) {
  std::sort(places_.begin(), places_.end());
  places_.erase(std::unique(places_.begin(), places_.end()), places_.end());
  const auto [a, b] = line_planes(w.patch[Operand::a], Brep::half_edge(edge));
  const int axis = w.tests().cross_axis(a, b);
  std::vector<std::uint32_t> order(places_.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
    return i != j && w.tests().compare(found.point(places_[i]), found.point(places_[j]), axis) ==
                         Sign::positive;
  });
  number_.resize(order.size());
  for (std::uint32_t k = 0; k < order.size(); ++k) {
    along_.push_back(places_[order[k]]);
    number_[order[k]] = k;
  }
}

std::uint32_t PlacesAlong::number(PlaceId place) const {
  return number_[static_cast<std::size_t>(std::lower_bound(places_.begin(), places_.end(), place) -
                                          places_.begin())];
}

}  // namespace sectile
