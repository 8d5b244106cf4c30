// Places on one line, in their order along it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "boolean/reduction/reduction.h"

namespace sectile {

class PlacesAlong {
 public:
  /// On the line of an edge of A. A place may be named several times.
  PlacesAlong(const Workspace& w, const Contacts& found, EdgeId edge, std::vector<PlaceId> places);

  std::span<const PlaceId> in_order() const { return along_; }
  PlaceId operator[](std::uint32_t number) const { return along_[number]; }
  std::size_t size() const { return along_.size(); }
  std::uint32_t number(PlaceId place) const;

 private:
  std::vector<PlaceId> places_;        // ascending
  std::vector<std::uint32_t> number_;  // of each of these
  std::vector<PlaceId> along_;
};

}  // namespace sectile
