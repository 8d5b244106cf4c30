// The paper's tables, its errata mended (docs/paper.md), as they are drawn beside a step.
#pragma once

#include "sectile/boolean.h"
#include "story/step.h"

namespace sectile::viewer {

PaperTable table_1();  ///< rows ∪ ∩ \; columns AonB+ AonB- BonA+ BonA-
PaperTable table_2();  ///< nine rows
PaperTable table_3();  ///< identical A, identical B, opposite A, opposite B; columns ∪ \ ∩
/// Section 5: its eight steps.
PaperTable steps_of_reduction();
/// Equation (4): rows ∪ ∩ \.
PaperTable equation_of_parts();
/// Section 3: how a split reclassifies what lies on its plane.
PaperTable rules_of_splitting();

/// The row of an operation in table_1() and equation_of_parts().
std::size_t row_of(Operation operation);

}  // namespace sectile::viewer
