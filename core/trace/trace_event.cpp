#include "sectile/trace.h"

#include "boolean/tables.h"

namespace sectile {

std::string_view TraceEvent::fact(std::string_view name) const {
  for (const auto& [known, value] : facts)
    if (known == name) return value;
  return {};
}

std::string_view reclassified(Operation operation, int solid, std::string_view before) {
  if (before == "in" || before == "out") return before;
  const Class on = before == "on+" ? Class::on_plus : Class::on_minus;
  return reclassified(operation, solid, on) == Class::in ? "in" : "out";
}

std::string describe(const TraceHalfPlane& h) {
  std::string text = (h.solid == 0 ? "A f" : "B f") + std::to_string(h.face);
  text += h.forward ? " forward: " : " backward: ";
  text += h.before;
  if (h.after != h.before) text += ", reclassified " + std::string(h.after) + " (Table I)";
  return text + (h.kept ? ", kept" : ", dropped");
}

}  // namespace sectile
