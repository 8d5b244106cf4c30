#include "sectile/trace.h"

namespace sectile {

std::string_view TraceEvent::fact(std::string_view name) const {
  for (const auto& [known, value] : facts)
    if (known == name) return value;
  return {};
}

std::string describe(const TraceHalfPlane& h) {
  std::string text = (h.solid == 0 ? "A f" : "B f") + std::to_string(h.face);
  text += h.forward ? " forward: " : " backward: ";
  text += h.before;
  if (h.after != h.before) text += ", reclassified " + std::string(h.after) + " (Table I)";
  return text + (h.kept ? ", kept" : ", dropped");
}

}  // namespace sectile
