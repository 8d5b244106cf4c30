#include "boolean/tables.h"
#include "sectile/trace.h"

namespace sectile {

std::string name_of(const TraceEntity& entity) {
  constexpr char letters[] = {'v', 'e', 'f'};
  return letters[static_cast<int>(entity.kind)] + std::to_string(entity.number);
}

std::string_view word_for(TraceEntity::Kind kind) {
  switch (kind) {
    case TraceEntity::Kind::vertex:
      return "vertex";
    case TraceEntity::Kind::edge:
      return "edge";
    case TraceEntity::Kind::face:
      break;
  }
  return "face";
}

std::string_view name_of(TraceClass cls) {
  switch (cls) {
    case TraceClass::in:
      return "in";
    case TraceClass::out:
      return "out";
    case TraceClass::on_plus:
      return "on+";
    case TraceClass::on_minus:
      break;
  }
  return "on-";
}

std::string_view name_of(PartEvent::Fate fate) {
  switch (fate) {
    case PartEvent::Fate::dropped:
      return "dropped";
    case PartEvent::Fate::kept:
      return "kept";
    case PartEvent::Fate::turned:
      break;
  }
  return "kept, turned inside out";
}

std::string part_name(int solid, TraceClass cls) {
  const char *own = solid == 0 ? "A" : "B", *other = solid == 0 ? "B" : "A";
  if (!is_on(cls)) return own + std::string(name_of(cls)) + other;
  return std::string(own) + "on" + other + (cls == TraceClass::on_plus ? "+" : "-");
}

TraceClass reclassified(Operation operation, int solid, TraceClass before) {
  if (!is_on(before)) return before;
  const Class on = before == TraceClass::on_plus ? Class::on_plus : Class::on_minus;
  return reclassified(operation, solid == 0 ? Operand::a : Operand::b, on) == Class::in
             ? TraceClass::in
             : TraceClass::out;
}

std::string describe(const TraceHalfPlane& h) {
  std::string text = (h.solid == 0 ? "A f" : "B f") + std::to_string(h.face);
  text += h.forward ? " forward: " : " backward: ";
  text += name_of(h.before);
  if (h.after != h.before) text += ", reclassified " + std::string(name_of(h.after)) + " (Table I)";
  return text + (h.kept ? ", kept" : ", dropped");
}

std::string describe(const std::array<WedgeEvent::Side, 2>& between) {
  const auto name = [](const WedgeEvent::Side& side) {
    return (side.solid == 0 ? "A " : "B ") + name_of(side.face);
  };
  return name(between[0]) + " and " + name(between[1]);
}

namespace {

template <class... Functions>
struct Visitor : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Visitor(Functions...) -> Visitor<Functions...>;

using Entities = std::vector<TraceEntity>;

}  // namespace

std::string_view kind_of(const TraceEvent& event) {
  // In the order of the variant.
  constexpr std::array<std::string_view, std::variant_size_v<TraceEvent>> kinds{
      "contact", "segment", "neighborhood", "null edge", "cut", "part", "wedge", "result"};
  return kinds[event.index()];
}

std::span<const TracePlace> places_of(const TraceEvent& event) {
  using Places = std::span<const TracePlace>;
  return std::visit(Visitor{[](const ContactEvent& e) { return Places(&e.place, 1); },
                            [](const NullEdgeEvent& e) { return Places(&e.place, 1); },
                            [](const PartEvent&) { return Places(); },
                            [](const ResultEvent&) { return Places(); },
                            [](const auto& e) { return Places(e.ends); }},
                    event);
}

std::vector<TraceEntity> entities_of(const TraceEvent& event, int solid) {
  const auto if_of = [solid](std::uint8_t owner, const TraceEntity& entity) {
    return owner == solid ? Entities{entity} : Entities{};
  };
  return std::visit(Visitor{[&](const ContactEvent& e) { return Entities{solid == 0 ? e.a : e.b}; },
                            [&](const SegmentEvent& e) { return Entities{solid == 0 ? e.a : e.b}; },
                            [&](const NeighborhoodEvent& e) { return solid == 0 ? e.a : e.b; },
                            [&](const NullEdgeEvent& e) { return if_of(e.solid, e.edge); },
                            [&](const CutEvent& e) { return if_of(e.solid, e.carrier); },
                            [&](const WedgeEvent& e) {
                              Entities faces;
                              for (const WedgeEvent::Side& side : e.between)
                                if (side.solid == solid) faces.push_back(side.face);
                              return faces;
                            },
                            [](const auto&) { return Entities{}; }},
                    event);
}

std::string meeting_of(const TraceEntity& a, const TraceEntity& b) {
  return std::string(word_for(a.kind)) + " on " + std::string(word_for(b.kind));
}

}  // namespace sectile
