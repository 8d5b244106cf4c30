#include "story/paper_tables.h"

namespace sectile::viewer {

std::size_t row_of(Operation operation) {
  return operation == Operation::unite ? 0 : operation == Operation::intersect ? 1 : 2;
}

PaperTable table_1() {
  return {"Table I: where parts on the other boundary go",
          {"", "AonB+", "AonB-", "BonA+", "BonA-"},
          {{"∪", "AoutB", "AinB", "BinA", "BinA"},
           {"∩", "AinB", "AoutB", "BoutA", "BoutA"},
           {"\\", "AinB", "AoutB", "BoutA", "BoutA"}},
          {},
          {}};
}

PaperTable table_2() {
  return {"Table II: an edge in a face",
          {"", "sector 1", "sector 2", "result 1", "result 2"},
          {{"1", "ON", "ON", "no", "no"},
           {"2", "ON", "IN", "no", "rule"},
           {"3", "ON", "OUT", "no", "not rule"},
           {"4", "IN", "ON", "rule", "no"},
           {"5", "IN", "IN", "no", "no"},
           {"6", "IN", "OUT", "yes", "no"},
           {"7", "OUT", "ON", "not rule", "no"},
           {"8", "OUT", "IN", "no", "yes"},
           {"9", "OUT", "OUT", "no", "no"}},
          {},
          {}};
}

PaperTable table_3() {
  return {"Table III: the rule",
          {"normals", "", "∪", "\\", "∩"},
          {{"identical", "A against B", "yes", "no", "no"},
           {"identical", "B against A", "no", "yes", "yes"},
           {"opposite", "A against B", "no", "yes", "yes"},
           {"opposite", "B against A", "no", "yes", "yes"}},
          {},
          {}};
}

PaperTable steps_of_reduction() {
  return {"Section 5: what is looked for",
          {"", "of A", "of B", "settled in"},
          {{"1", "edge", "edge", "6.2"},
           {"2", "edge", "vertex", "6.2"},
           {"3", "vertex", "edge", "6.2"},
           {"4", "vertex", "vertex", "6.2"},
           {"5", "edge", "face", "6.1"},
           {"6", "face", "edge", "6.1"},
           {"7", "vertex", "face", "6.1"},
           {"8", "face", "vertex", "6.1"}},
          {},
          {}};
}

PaperTable equation_of_parts() {
  return {
      "Equation (4): what is glued",
      {"", "of A", "of B"},
      {{"A ∪ B", "AoutB", "BoutA"}, {"A ∩ B", "AinB", "BinA"}, {"A \\ B", "AoutB", "BinA, turned"}},
      {},
      {}};
}

PaperTable rules_of_splitting() {
  return {"Section 3: what lies on the plane",
          {"ON", "goes"},
          {{"sector, normal as the plane's", "BELOW"},
           {"sector, normal against it", "ABOVE"},
           {"edge between ABOVE and BELOW", "BELOW"}},
          {},
          {}};
}

}  // namespace sectile::viewer
