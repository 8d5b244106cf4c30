// Sections 4 to 6.2.1: parts of boundaries, where parts on the other boundary go, and what is
// classified.
#include "tour/station.h"

namespace sectile::viewer {
namespace {

Figure two_bricks() {
  return Figure()
      .closed(Ink::a, {{14, 54}, {46, 54}, {46, 26}, {14, 26}})
      .line(Ink::a, {{46, 54}, {56, 48}, {56, 20}, {24, 20}, {14, 26}})
      .line(Ink::a, {{46, 26}, {56, 20}})
      .closed(Ink::b, {{38, 40}, {74, 40}, {74, 12}, {38, 12}})
      .line(Ink::b, {{74, 40}, {86, 33}, {86, 5}, {50, 5}, {38, 12}})
      .line(Ink::b, {{74, 12}, {86, 5}})
      .line(Ink::lit, {{38, 26}, {38, 40}, {46, 40}, {56, 34}, {56, 20}, {46, 20}, {38, 26}}, 1.4f);
}

Figure let_in() {
  return Figure()
      .area(Ink::a, {{8, 56}, {88, 56}, {88, 32}, {8, 32}})
      .area(Ink::b, {{24, 44}, {38, 44}, {38, 32}, {76, 32}, {76, 8}, {24, 8}})
      .text(Ink::a, {14, 50}, "A")
      .text(Ink::b, {50, 18}, "B")
      .line(Ink::lit, {{38, 32}, {76, 32}}, 1.8f)
      .text(Ink::lit, {58, 37}, "normals opposite: on-");
}

Station figure_11() {
  return {"Four parts",
          {"figure 11", "components"},
          "fig11",
          Phase::components,
          "",
          "Two bricks, a corner of each in the other. Their boundaries cut each other along the "
          "heavy line into four parts: AinB, AoutB, BinA and BoutA. Every Boolean of A and B is "
          "made of these four, and of nothing else.",
          two_bricks(),
          "Of which two parts is A ∩ B made?",
          "AinB and BinA: of each boundary what lies inside the other solid.",
          0.45};
}

Station equation_4() {
  return {"Gluing what is kept",
          {"gluing"},
          "fig11",
          Phase::gluing,
          "",
          "Equation (4): A ∪ B glues AoutB to BoutA, A ∩ B glues AinB to BinA, and A \\ B glues "
          "AoutB to BinA turned inside out. The parts fit, since all of them end at the same "
          "intersection curve. Each step here glues one wedge along one segment of it.",
          Figure()
              .text(Ink::black, {50, 14}, "b(A ∪ B)  =  AoutB & BoutA")
              .text(Ink::black, {50, 30}, "b(A ∩ B)  =  AinB & BinA")
              .text(Ink::black, {50, 46}, "b(A \\ B)  =  AoutB & (BinA)⁻¹"),
          "Why is BinA turned inside out for A \\ B?",
          "It becomes the wall of the hole: material is now on its other side.",
          0.45};
}

Station figure_12() {
  return {"Eight parts, and Table I for ∪",
          {"figure 12", "Table I, ∪"},
          "fig12",
          Phase::components,
          "",
          "Where faces lie in one plane there are four parts more: AonB+ and BonA+ with equal "
          "normals, AonB- and BonA- with opposite ones. Table I lumps them with the four. For ∪, "
          "AonB+ joins AoutB; all others vanish inside, and count as in.",
          let_in(),
          "B stands on A. What becomes of the faces where they touch?",
          "AonB- goes to AinB and BonA- to BinA: both are dropped, nothing is left between.",
          0.45,
          true};
}

Station table_1_intersect() {
  return {"Table I for ∩",
          {"Table I, ∩"},
          "fig01",
          Phase::vertex_vertex,
          "Table I",
          "For ∩, AonB+ counts as AinB: where A and B share a face with material on one side, the "
          "intersection has it too, once. It is taken from A; BonA+ goes to BoutA and is dropped. "
          "With opposite normals nothing of the intersection lies there.",
          Figure()
              .area(Ink::a, {{8, 50}, {60, 50}, {60, 22}, {8, 22}})
              .area(Ink::b, {{36, 50}, {92, 50}, {92, 12}, {36, 12}})
              .line(Ink::lit, {{36, 50}, {60, 50}}, 1.8f)
              .text(Ink::lit, {48, 56}, "on+: from A, once"),
          "Why is the shared face not taken from both operands?",
          "It would be there twice, and the boundary would not be one surface."};
}

Station table_1_subtract() {
  return {"Table I for \\",
          {"Table I, \\"},
          "fig02",
          Phase::vertex_vertex,
          "Table I",
          "The paper's row for \\ has its two entries for A exchanged; equation (5) says what is "
          "right. AonB- goes to AoutB: B only touches it from outside, so A keeps it. AonB+ goes "
          "to AinB: behind it the material is taken away.",
          Figure()
              .area(Ink::a, {{10, 52}, {90, 52}, {90, 20}, {10, 20}})
              .area(Ink::b, {{36, 52}, {64, 52}, {50, 20}})
              .line(Ink::lit, {{36, 52}, {64, 52}}, 1.8f)
              .text(Ink::lit, {50, 57}, "on+: goes"),
          "The wedge ends flush with the block's front. Which class has the block's front there?",
          "AonB+: same plane, same normal. For \\ it counts as inside, and is dropped."};
}

Station figure_13() {
  return {"A vertex inside a face",
          {"figure 13", "vertex_face"},
          "fig13",
          Phase::vertex_face,
          "",
          "Section 6.1: a vertex of one solid lies inside a face of the other. Its neighborhood is "
          "classified against the plane of that face, as in a split; above and below are called "
          "out and in. The face itself only gets a mark where the cut runs through.",
          Figure()
              .closed(Ink::a, {{10, 50}, {66, 50}, {90, 20}, {34, 20}})
              .line(Ink::b, {{50, 35}, {40, 8}})
              .dashed(Ink::b, {{50, 35}, {44, 58}})
              .dashed(Ink::b, {{50, 35}, {64, 57}})
              .line(Ink::lit, {{46, 34}, {54, 36}}, 1.8f)
              .dot(Ink::lit, {46, 34})
              .dot(Ink::lit, {54, 36})
              .text(Ink::lit, {68, 34}, "null edge"),
          "What marks the place inside the face?",
          "A null edge that begins an inner loop of its own, joined to nothing yet."};
}

Station figure_14() {
  return {"Do two sectors cross?",
          {"figure 14"},
          "fig11",
          Phase::vertex_face,
          "Figure 14",
          "Two sectors can cross only along the line in which their planes meet: its direction is "
          "the cross product of the normals. If that direction, or its opposite, lies within both "
          "sectors, they cross. Here every such question is answered exactly.",
          Figure()
              .area(Ink::a, {{20, 44}, {80, 44}, {60, 26}})
              .area(Ink::b, {{50, 8}, {34, 56}, {66, 50}})
              .arrow(Ink::lit, {50, 37}, {88, 37})
              .text(Ink::lit, {88, 32}, "int = n1 × n2")
              .arrow(Ink::a, {30, 42}, {30, 28})
              .text(Ink::a, {26, 30}, "n1")
              .arrow(Ink::b, {44, 18}, {28, 14})
              .text(Ink::b, {24, 14}, "n2"),
          "What if the cross product is zero?",
          "The planes are parallel; in one place they are the same: the sectors are coplanar."};
}

Station figure_15() {
  return {"Is a direction within a sector?",
          {"figure 15"},
          "fig22",
          Phase::vertex_vertex,
          "",
          "Three cases by the angle of the sector. Below 180 degrees: the direction lies to the "
          "left of one side and to the right of the other. Above: it does not lie in the rest. "
          "Exactly 180: one side of the line decides. Notches make wide sectors.",
          Figure()
              .area(Ink::a, {{20, 40}, {34, 40}, {30, 20}})
              .text(Ink::black, {22, 50}, "< 180°")
              .area(Ink::a, {{38, 40}, {62, 40}, {58, 26}, {50, 22}, {42, 26}})
              .dot(Ink::black, {50, 40})
              .text(Ink::black, {50, 50}, "= 180°")
              .area(Ink::a, {{80, 34}, {94, 46}, {94, 22}, {80, 14}, {68, 22}, {66, 40}})
              .dot(Ink::black, {80, 34})
              .text(Ink::black, {80, 54}, "> 180°")
              .arrow(Ink::lit, {20, 40}, {31, 31}),
          "Which corners have sectors of more than 180 degrees?",
          "Reentrant ones, such as those at the floor of a notch."};
}

}  // namespace

std::vector<Station> stations_of_sections_4_to_6() {
  return {figure_11(),        equation_4(), figure_12(), table_1_intersect(),
          table_1_subtract(), figure_13(),  figure_14(), figure_15()};
}

}  // namespace sectile::viewer
