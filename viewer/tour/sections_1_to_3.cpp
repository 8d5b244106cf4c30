// Sections 1 to 3: why special cases are the rule, what a result may be, and how a plane splits.
#include "tour/station.h"

namespace sectile::viewer {
namespace {

// The block with two prongs of figures 4 to 10, in the paper's view.
Figure prongs() {
  return Figure()
      .closed(Ink::a, {{14, 56}, {74, 56}, {74, 16}, {54, 36}, {34, 36}, {14, 16}})
      .line(Ink::a, {{74, 56}, {86, 48}, {86, 8}, {74, 16}})
      .line(Ink::a, {{14, 16}, {26, 8}, {34, 16}})
      .line(Ink::a, {{54, 36}, {66, 28}, {86, 8}})
      .line(Ink::a, {{34, 36}, {46, 28}, {66, 28}})
      .line(Ink::a, {{26, 8}, {46, 28}});
}

Figure neighborhood_of_3(const char* to_11, const char* to_4, const char* to_5) {
  return Figure()
      .line(Ink::a, {{50, 34}, {20, 8}})
      .line(Ink::a, {{50, 34}, {88, 34}})
      .line(Ink::a, {{50, 34}, {68, 14}})
      .dot(Ink::black, {50, 34})
      .text(Ink::black, {47, 40}, "3")
      .text(Ink::black, {16, 8}, "11")
      .text(Ink::black, {93, 34}, "5")
      .text(Ink::black, {72, 12}, "4")
      .text(Ink::lit, {31, 26}, to_11)
      .text(Ink::lit, {56, 19}, to_4)
      .text(Ink::lit, {74, 39}, to_5);
}

Station figure_1() {
  return {"Two profiles",
          {"figure 1"},
          "fig01",
          Phase::cleanup,
          "",
          "Two profiles, swept along directions that cross, are intersected. Bottoms, tops and "
          "walls lie flush: nearly every contact is a special case. An algorithm that knows faces "
          "only as crossing faces fails here; this one never asks whether a case is special.",
          Figure()
              .closed(Ink::a, {{6, 26}, {30, 26}, {30, 14}, {18, 14}, {18, 8}, {6, 8}})
              .closed(Ink::b,
                      {{40, 26}, {64, 26}, {64, 8}, {58, 8}, {58, 20}, {46, 20}, {46, 8}, {40, 8}})
              .text(Ink::a, {18, 31}, "A, from the front")
              .text(Ink::b, {53, 31}, "B, from the side")
              .arrow(Ink::grey, {68, 26}, {74, 36})
              .closed(Ink::black, {{56, 58}, {84, 58}, {84, 48}, {70, 48}, {70, 42}, {56, 42}})
              .line(Ink::black, {{84, 58}, {94, 50}, {94, 40}, {84, 48}})
              .line(Ink::black, {{70, 42}, {74, 38}, {62, 38}, {56, 42}})
              .text(Ink::black, {30, 50}, "A ∩ B"),
          "Which faces of the result come from both operands at once?",
          "The bottom, the top and the outer walls: A and B share their planes there."};
}

Station figure_2() {
  return {"Not a 2-manifold",
          {"figure 2"},
          "fig02",
          Phase::components,
          "",
          "A wedge is cut out of a block so that its top edge just reaches the block's top. Four "
          "faces meet along that line. No 2-manifold looks like this, yet the two operands are "
          "as ordinary as can be: Booleans of 2-manifolds need not be 2-manifolds.",
          Figure()
              .closed(Ink::a, {{16, 56}, {72, 56}, {72, 18}, {16, 18}})
              .line(Ink::a, {{72, 56}, {88, 46}, {88, 8}, {32, 8}, {16, 18}})
              .line(Ink::a, {{72, 18}, {88, 8}})
              .closed(Ink::b, {{30, 44}, {58, 44}, {44, 18}})
              .line(Ink::lit, {{44, 18}, {60, 8}}, 1.6f),
          "How many faces meet in the coloured line?",
          "Four: two halves of the top and two walls of the tunnel."};
}

Station figure_3() {
  return {
      "Two edges in one place",
      {"figure 3", "cleanup"},
      "fig02",
      Phase::cleanup,
      "",
      "The result is kept as if it were a 2-manifold: two edges in one place, each with its own "
      "two faces. Section 2 allows that in condition (3'). Here one rule decides which: each "
      "wedge of material around a line has its own edge. So results are operands again.",
      Figure()
          .area(Ink::a, {{8, 50}, {24, 50}, {24, 20}, {8, 20}})
          .closed(Ink::a,
                  {{8, 56}, {44, 56}, {44, 18}, {27, 18}, {36, 46}, {16, 46}, {25, 18}, {8, 18}})
          .text(Ink::black, {26, 10}, "(a) apart")
          .closed(Ink::a, {{56, 56}, {92, 56}, {92, 18}, {56, 18}})
          .closed(Ink::a, {{64, 46}, {84, 46}, {74, 19}})
          .text(Ink::black, {74, 10}, "(b) an edge on a face"),
      "Is the result above taken as (a) or as (b)?",
      "As (a): the two wedges of material beside the line part, and each has an edge there.",
      0.2,
      false};
}

Station figure_4() {
  return {"Splitting by a plane",
          {"figure 4"},
          "fig04",
          Phase::components,
          "",
          "Section 3 warms up with an easier problem: a plane SP splits a solid S into Above and "
          "Below. Here SP runs through the floor of the notch, so that a face of S lies in it. "
          "Above falls into two pieces, which is quite all right.",
          prongs().dashed(Ink::lit, {{4, 36}, {96, 36}}).text(Ink::lit, {8, 31}, "SP"),
          "To which part does the floor of the notch belong?",
          "To Below: material lies under it, so it becomes part of Below's top."};
}

Station figure_5() {
  return {
      "The vertices on the plane",
      {"figure 5", "reduction"},
      "fig04",
      Phase::reduction,
      "",
      "First, every edge that passes through the plane is divided there. After that only "
      "vertices matter: four were there, four are new. The whole problem has become eight small "
      "ones, one for each vertex on the plane.",
      prongs()
          .dot(Ink::lit, {14, 36})
          .dot(Ink::lit, {34, 36})
          .dot(Ink::lit, {54, 36})
          .dot(Ink::lit, {74, 36})
          .dot(Ink::lit, {46, 28})
          .dot(Ink::lit, {66, 28})
          .dot(Ink::lit, {86, 28})
          .dot(Ink::lit, {26, 28})
          .text(Ink::black, {10, 38}, "1")
          .text(Ink::black, {33, 41}, "3")
          .text(Ink::black, {55, 41}, "5")
          .text(Ink::black, {78, 38}, "7"),
      "Which of the eight vertices are new?",
      "The four on the outer, upright edges; the corners of the notch floor were there."};
}

Station figure_6() {
  return {"The neighborhood of a vertex",
          {"figure 6"},
          "fig04",
          Phase::reduction,
          "vertex",
          "The neighborhood of a vertex is the ring of edges and sectors around it. Vertex 3 has "
          "three edges, to 11, 4 and 5, and three sectors between them. The sphere beside the "
          "picture shows the same ring as arcs around a point.",
          neighborhood_of_3("sector", "", "sector"),
          "How many sectors does a vertex with five edges have?",
          "Five: one between each two edges that follow each other."};
}

Station figure_7() {
  return {"Above, on, below",
          {"figure 7"},
          "fig04",
          Phase::vertex_face,
          "Section 3",
          "Each edge of the ring is labelled by where it leads: ABOVE, ON or BELOW. Then ON "
          "disappears. A sector in the plane goes to the side of the material; a lone ON edge goes "
          "where the rules say. Afterwards everything is on one side or the other.",
          neighborhood_of_3("ABOVE", "ON", "ON").text(Ink::b, {66, 52}, "then ON becomes BELOW"),
          "The sector (4, 3, 5) lies in the plane, with material below. Where does it go?",
          "BELOW: its normal is that of the plane."};
}

Station figure_8() {
  return {
      "All eight, classified",
      {"figure 8"},
      "fig04",
      Phase::vertex_face,
      "",
      "The same is done at every vertex on the plane. An edge in the plane is classified twice, "
      "once at each end; the rules see to it that both ends agree. That is all the "
      "co-ordination there is between the eight problems.",
      prongs()
          .text(Ink::lit, {10, 28}, "A")
          .text(Ink::lit, {10, 46}, "B")
          .text(Ink::lit, {44, 41}, "B")
          .text(Ink::lit, {29, 26}, "A")
          .text(Ink::lit, {60, 26}, "A")
          .text(Ink::lit, {78, 28}, "A")
          .text(Ink::lit, {78, 46}, "B"),
      "Why must both ends of an ON edge get the same label?",
      "Otherwise the edge would belong to Above at one end and to Below at the other."};
}

Station figure_9() {
  return {"A null edge",
          {"figure 9"},
          "fig04",
          Phase::null_edges,
          "Figure 9.",
          "Where the ring changes from ABOVE to BELOW the vertex falls apart in two: one has the "
          "edges above, one those below. A null edge, of no length, joins them. Its ends are drawn "
          "apart here, though they are in one place.",
          Figure()
              .line(Ink::a, {{50, 26}, {22, 8}})
              .line(Ink::a, {{50, 40}, {88, 40}})
              .line(Ink::a, {{50, 40}, {68, 24}})
              .line(Ink::lit, {{50, 26}, {50, 40}}, 1.6f)
              .dot(Ink::black, {50, 26})
              .dot(Ink::black, {50, 40})
              .text(Ink::black, {45, 24}, "3'")
              .text(Ink::black, {45, 43}, "3")
              .text(Ink::lit, {60, 33}, "null edge"),
          "How far apart are the two ends of a null edge?",
          "Not at all: both have the coordinates of the vertex."};
}

Station figure_10() {
  return {"Joining the null edges",
          {"figure 10", "joining"},
          "fig04",
          Phase::joining,
          "",
          "Null edges are joined in pairs by new edges across the faces, two for each cut: one for "
          "each side. When the last pair is joined, the loop closes, the null edges go, and the "
          "surface falls apart along the cut.",
          Figure()
              .line(Ink::a, {{20, 10}, {20, 26}})
              .line(Ink::a, {{20, 36}, {20, 54}})
              .line(Ink::a, {{76, 10}, {76, 26}})
              .line(Ink::a, {{76, 36}, {76, 54}})
              .line(Ink::lit, {{20, 26}, {20, 36}}, 1.6f)
              .line(Ink::lit, {{76, 26}, {76, 36}}, 1.6f)
              .line(Ink::b, {{20, 26}, {76, 26}})
              .line(Ink::b, {{20, 36}, {76, 36}})
              .text(Ink::black, {48, 20}, "edge of Above")
              .text(Ink::black, {48, 42}, "edge of Below"),
          "Why are there two new edges and not one?",
          "One becomes part of the rim of Above, the other of Below."};
}

}  // namespace

std::vector<Station> stations_of_sections_1_to_3() {
  return {figure_1(), figure_2(), figure_3(), figure_4(), figure_5(),
          figure_6(), figure_7(), figure_8(), figure_9(), figure_10()};
}

}  // namespace sectile::viewer
