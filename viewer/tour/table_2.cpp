// Section 6.2.2.1: an edge in a face, all nine rows of Table II. The samples' profiles are the
// figures: B's face is the level line, A's edge the point in its middle.
#include <array>

#include "tour/station.h"

namespace sectile::viewer {
namespace {

// A's profile around (4, 4), in the sample's units.
Figure profile(const std::vector<FigurePoint>& a) {
  const auto place = [](FigurePoint p) {
    return FigurePoint{50 + (p.x - 4) * 14, 30 - (p.y - 4) * 13};
  };
  std::vector<FigurePoint> placed;
  for (const FigurePoint& p : a) placed.push_back(place(p));
  return Figure()
      .area(Ink::b, {{4, 30}, {96, 30}, {96, 58}, {4, 58}})
      .area(Ink::a, placed)
      .dot(Ink::lit, {50, 30})
      .text(Ink::b, {88, 52}, "B")
      .text(Ink::a, {12, 10}, "A");
}

struct RowText {
  const char* title;
  std::vector<FigurePoint> a;
  const char* text;
  const char* question;
  const char* answer;
};

std::vector<RowText> rows() {
  return {
      {"ON and ON",
       {{4, 2}, {6, 4}, {4, 4}, {2, 4}},
       "An edge of A lies in a face of B, and so do both sectors beside it. Entirely coplanar "
       "sectors are not considered to intersect: whatever Table I makes of them, it makes the same "
       "of both.",
       "Why is nothing cut along this edge?",
       "Both sectors get the same class, so they stay together."},
      {"ON and IN",
       {{2, 4}, {4, 2}, {4, 4}},
       "One sector lies in the face, the other goes into B. If the ON sector counts as OUT, the "
       "two are on different sides and the second one is deemed to cross: Table III has the rule, "
       "which depends on operation, normals, and whose sector it is.",
       "When is the IN sector cut off here?",
       "When the ON sector is reclassified OUT: then the sides differ."},
      {"ON and OUT",
       {{2, 4}, {4, 4}, {4, 6}},
       "One sector lies in the face, the other leads out of B. Now the negation of the rule "
       "counts: "
       "if the ON sector is OUT as well, both stay together. With opposite normals, as here, it is "
       "Table III, row 3.",
       "For ∪ the ON sector here counts as IN. Is there a cut?",
       "Yes: IN beside OUT are different sides."},
      {"IN and ON",
       {{4, 4}, {4, 2}, {6, 4}},
       "Row 2 with the two sectors exchanged: which is first depends on the end from which one "
       "looks. The table has both, so that the classifier at each end of the edge finds the same "
       "answer.",
       "Which row does the other end of this edge see?",
       "Row 2: from there the ON sector comes first."},
      {"IN and IN",
       {{4, 4}, {3, 2}, {5, 2}},
       "Both sectors beside the edge go into B: A touches the face from inside. There is no "
       "intersection. For the union nothing needs to be done; A lies within B here.",
       "What of A is kept in A ∪ B here?",
       "Nothing near the edge: it all lies inside B."},
      {"IN and OUT",
       {{4, 4}, {2, 6}, {2, 2}},
       "One sector goes in, one goes out: the surface of A passes through the face along its edge. "
       "The sector inside is considered to intersect, so the cut runs between the two.",
       "On which side of the edge does the cut run?",
       "On that of the IN sector: the edge stays with the part outside."},
      {"OUT and ON",
       {{4, 4}, {6, 4}, {4, 6}},
       "Row 3 turned around. Figure 18 uses this row and row 4 together: an edge of each solid "
       "lies "
       "in a face of the other, and both answers must fit.",
       "Here A \\ B is asked for. Is A cut along the edge?",
       "No: AonB- counts as AoutB for \\, so both sectors are OUT."},
      {"OUT and IN",
       {{4, 4}, {6, 2}, {6, 6}},
       "Row 6 from the other end: the surface passes through the face, and the IN sector, now the "
       "second one, is considered to intersect.",
       "Does the operation matter in this row?",
       "No: nothing is ON, so Table I has nothing to say."},
      {"OUT and OUT",
       {{4, 4}, {5, 6}, {3, 6}},
       "Both sectors lead out of B: A stands on its edge on the face, and they touch in a line. No "
       "intersection, says the table. But two wedges of material meet in that line, and each needs "
       "an edge of its own.",
       "A stands on B on an edge. What does A ∪ B have in that line?",
       "An edge for each of the two wedges of material that touch there."},
  };
}

}  // namespace

std::vector<Station> stations_of_table_2() {
  std::vector<Station> made;
  const std::vector<RowText> texts = rows();
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string number = std::to_string(i + 1);
    Station station;
    station.title = "Table II, row " + number + ": " + texts[i].title;
    station.covers = {"Table II, row " + number};
    if (i == 5) station.covers.insert(station.covers.end(), {"figure 17", "vertex_vertex"});
    if (i == 0) station.covers.emplace_back("figure 16");
    station.sample = "table2-row" + number;
    station.phase = Phase::vertex_vertex;
    station.step = "row " + number;
    station.text = texts[i].text;
    station.figure = profile(texts[i].a);
    station.question = texts[i].question;
    station.answer = texts[i].answer;
    made.push_back(std::move(station));
  }
  return made;
}

}  // namespace sectile::viewer
