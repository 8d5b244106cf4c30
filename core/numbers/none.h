#pragma once

#include <cstdint>

namespace sectile {

/// No such element, among raw indices.
inline constexpr std::uint32_t none = 0xFFFFFFFFu;

}  // namespace sectile
