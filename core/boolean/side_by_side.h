// Work on both operands beside each other: their patches share nothing that is changed.
#pragma once

#include <cstddef>

#include "boolean/operand.h"
#include "numbers/threshold.h"
#include "parallel/parallel.h"

namespace sectile {

/// Calls body(operand) for both operands. `work`: how many elements are looked at; where these are
/// few, starting a thread would take longer than they do.
template <class Body>
void for_both_operands(std::size_t work, const Body& body) {
  constexpr std::size_t enough = threshold(500, 1);
  if (work < enough) {
    for (const Operand s : both_operands) body(s);
  } else {
    parallel::invoke([&] { body(Operand::a); }, [&] { body(Operand::b); });
  }
}

}  // namespace sectile
