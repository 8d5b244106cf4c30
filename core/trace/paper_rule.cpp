// Which of the paper's cases a neighborhood is. The operation does not use this: all cases come out
// of one sort (boolean/neighborhoods/), and this says which of them came out.
#include <array>
#include <optional>

#include "sectile/trace.h"

namespace sectile {
namespace {

using HalfPlane = TraceHalfPlane;

bool is_on(const HalfPlane& h) {
  return is_on(h.before);
}

std::string upper(const HalfPlane& h) {
  return is_on(h) ? "ON" : h.before == TraceClass::in ? "IN" : "OUT";
}

// What one solid has at the segment: one face or edge, or more.
struct Side {
  std::vector<const HalfPlane*> half_planes;
  bool is_pair() const {
    return half_planes.size() == 2 && half_planes[0]->carrier == half_planes[1]->carrier;
  }
  bool is_edge() const { return is_pair() && half_planes[0]->carrier.is_edge(); }
  bool is_face() const { return is_pair() && half_planes[0]->carrier.is_face(); }
  const HalfPlane& get(bool forward) const {
    return half_planes[0]->forward == forward ? *half_planes[0] : *half_planes[1];
  }
  bool is_cut() const { return half_planes[0]->cut; }
};

// Table II: the two sectors beside an edge against the face in which it lies.
constexpr std::array<std::array<int, 3>, 3> table_2 = {{
    //        second: ON  IN  OUT
    /* ON  */ {1, 2, 3},
    /* IN  */ {4, 5, 6},
    /* OUT */ {7, 8, 9},
}};

int code(const HalfPlane& h) {
  return is_on(h) ? 0 : h.before == TraceClass::in ? 1 : 2;
}

const char* sign(Operation operation) {
  switch (operation) {
    case Operation::unite:
      return "∪";
    case Operation::intersect:
      return "∩";
    case Operation::subtract:
      break;
  }
  return "\\";
}

// Table III: the rule holds if the ON sector is reclassified OUT.
std::string table_3(const HalfPlane& on, Operation operation) {
  std::string text = on.before == TraceClass::on_plus ? "identical" : "opposite";
  text += on.solid == 0 ? ", A against B, " : ", B against A, ";
  text += sign(operation);
  return text + (on.after == TraceClass::out ? ": the rule holds" : ": the rule does not hold");
}

PaperRule edge_in_face(const Side& edge, const Side& face, Operation operation) {
  // The order of the two sectors around a vertex depends on the end from which one looks.
  const HalfPlane &first = edge.get(false), &second = edge.get(true);
  const int row =
      table_2[static_cast<std::size_t>(code(first))][static_cast<std::size_t>(code(second))];
  const int turned =
      table_2[static_cast<std::size_t>(code(second))][static_cast<std::size_t>(code(first))];
  PaperRule rule;
  rule.where = "Table II, row " + std::to_string(row);
  if (turned != row) rule.where += " (row " + std::to_string(turned) + " from the other end)";
  rule.says = "Beside the edge the sectors are " + upper(first) + " and " + upper(second) + ". ";
  const bool apart = first.after != second.after;
  const bool rule_decides = is_on(first) != is_on(second);
  if (rule_decides) {
    const HalfPlane& on = is_on(first) ? first : second;
    rule.where += ", Table III (" + table_3(on, operation) + ")";
    rule.says += "The ON sector counts as " + std::string(name_of(on.after)) + ". ";
  }
  if (apart)
    rule.says +=
        "The sectors are on different sides: the surface passes through the face along the edge.";
  else if (edge.is_cut() || face.is_cut())
    rule.says +=
        "The paper sees no intersection; but two wedges of material touch in this line, and each "
        "gets an edge of its own.";
  else
    rule.says += "Both sectors are on one side: no intersection.";
  return rule;
}

// Whether the surfaces cross in an edge that they share.
std::string what_follows(const Side& a, const Side& b) {
  const auto differ = [](const Side& s) {
    return s.half_planes[0]->after != s.half_planes[1]->after;
  };
  if (differ(a) || differ(b)) return " So the surfaces cross in this line.";
  if (a.is_cut() || b.is_cut())
    return " The surfaces do not cross, but two wedges of material touch in this line, and each "
           "gets an edge of its own.";
  return " So nothing is cut.";
}

PaperRule edge_on_edge(const Side& a, const Side& b) {
  std::vector<const HalfPlane*> on;
  const HalfPlane* other = nullptr;  // A's sector that is not coplanar with one of B
  for (const HalfPlane* h : a.half_planes) {
    if (is_on(*h))
      on.push_back(h);
    else
      other = h;
  }
  if (on.size() == 2)
    return {"figure 20a",
            "The edges coincide and all sectors are pairwise coplanar; coplanar "
            "sectors do not intersect." +
                what_follows(a, b)};
  if (on.size() == 1) {
    const bool identical = on[0]->before == TraceClass::on_plus,
               in = other->before == TraceClass::in;
    const char letter = identical ? (in ? 'b' : 'c') : (in ? 'e' : 'd');
    return {std::string("figure 20") + letter,
            std::string("The edges coincide. One pair of sectors is coplanar, with ") +
                (identical ? "equal" : "opposite") + " normals; A's other sector lies " +
                (in ? "inside" : "outside") + " B. Table I breaks the tie." + what_follows(a, b)};
  }
  const bool mixed = a.half_planes[0]->before != a.half_planes[1]->before;
  return {mixed ? "figure 19a" : "figure 19b",
          (mixed ? "The edges coincide. Sorted around their line the four sectors come in mixed "
                   "order."
                 : "The edges coincide. Sorted around their line the sectors of A and of B do not "
                   "mix.") +
              what_follows(a, b)};
}

}  // namespace

PaperRule paper_rule(const NeighborhoodEvent& neighborhood, Operation operation) {
  Side side[2];
  for (const HalfPlane& h : neighborhood.half_planes) side[h.solid].half_planes.push_back(&h);
  if (!side[0].is_pair() || !side[1].is_pair())
    return {"beyond the paper",
            "More than one face or edge of a solid has this line, so that no row of the paper's "
            "tables fits; the same sort of all half-planes around the line decides."};
  if (side[0].is_edge() && side[1].is_edge()) return edge_on_edge(side[0], side[1]);
  if (side[0].is_edge()) return edge_in_face(side[0], side[1], operation);
  if (side[1].is_edge()) return edge_in_face(side[1], side[0], operation);
  return {"figure 14", "Two faces cross: each is cut along their common line."};
}

}  // namespace sectile
