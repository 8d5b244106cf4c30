// The two operands, A and B, and what there is of each of them.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sectile {

enum class Operand : std::uint8_t { a, b };

inline constexpr Operand both_operands[] = {Operand::a, Operand::b};

constexpr Operand other(Operand operand) {
  return operand == Operand::a ? Operand::b : Operand::a;
}

template <class T>
struct PerOperand {
  T of[2]{};

  constexpr T& operator[](Operand operand) { return of[static_cast<std::size_t>(operand)]; }
  constexpr const T& operator[](Operand operand) const {
    return of[static_cast<std::size_t>(operand)];
  }

  constexpr T* begin() { return of; }
  constexpr T* end() { return of + 2; }
  constexpr const T* begin() const { return of; }
  constexpr const T* end() const { return of + 2; }
};

}  // namespace sectile
