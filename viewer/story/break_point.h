// What a break point names, and which events it stops at.
#pragma once

#include <optional>
#include <string>

#include "sectile/trace.h"

namespace sectile::viewer {

class BreakPoint {
 public:
  explicit BreakPoint(const std::string& text);
  bool matches(const TraceEvent& event) const;

 private:
  std::string text_, turned_;             ///< a kind; a kind of contact the other way round
  std::optional<TraceEntity> entity_[2];  ///< of A, of B; nothing: any
  std::optional<TraceEntity> either_;     ///< an entity of any solid
};

}  // namespace sectile::viewer
