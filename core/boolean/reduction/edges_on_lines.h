// Which edges run along crowded lines (boolean/near/crowded_lines.h), whatever they meet.
#pragma once

#include <cstdint>
#include <optional>

#include "boolean/workspace.h"

namespace sectile {

class EdgesOnLines {
 public:
  EdgesOnLines(const Workspace& w, Operand operand) : w_(w), patch_(w.patch[operand]) {}

  /// The number of the crowded line on which a loaded edge is; none if it is on no such.
  std::optional<std::uint32_t> line_of(EdgeId edge) const;

 private:
  bool is_on(std::uint32_t line, EdgeId edge) const;

  const Workspace& w_;
  const Patch& patch_;
};

}  // namespace sectile
