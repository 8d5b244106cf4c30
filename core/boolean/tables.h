// Table I of the paper in its corrected form, as data: the part of the four-way classification into
// which the pieces that lie on the other boundary go. docs/paper.md says what was wrong and how the
// other tables follow from this one.
#pragma once

#include "boolean/operand.h"
#include "sectile/boolean.h"

namespace sectile {

/// Where a piece of one boundary lies relative to the other solid.
enum class Class : std::uint8_t { in, out, on_plus, on_minus };

struct ReclassificationRow {
  Operation operation;
  Class a_on_b_plus, a_on_b_minus, b_on_a_plus, b_on_a_minus;  ///< in or out
};

inline constexpr ReclassificationRow table_1[] = {
    {Operation::unite, Class::out, Class::in, Class::in, Class::in},
    {Operation::intersect, Class::in, Class::out, Class::out, Class::out},
    {Operation::subtract, Class::in, Class::out, Class::out, Class::out},
};

/// The four-way class of a piece of an operand's boundary.
constexpr Class reclassified(Operation operation, Operand operand, Class c) {
  if (c == Class::in || c == Class::out) return c;
  const ReclassificationRow& row = table_1[static_cast<int>(operation)];
  if (c == Class::on_plus) return operand == Operand::a ? row.a_on_b_plus : row.b_on_a_plus;
  return operand == Operand::a ? row.a_on_b_minus : row.b_on_a_minus;
}

/// Equation (4): is a part of the four-way classification in the result's boundary?
constexpr bool kept(Operation operation, Operand operand, Class c) {
  const Class four_way = reclassified(operation, operand, c);
  const bool outside =
      operation == Operation::unite || (operation == Operation::subtract && operand == Operand::a);
  return four_way == (outside ? Class::out : Class::in);
}

/// Equation (4): is the part turned inside out?
constexpr bool reversed(Operation operation, Operand operand) {
  return operation == Operation::subtract && operand == Operand::b;
}

}  // namespace sectile
