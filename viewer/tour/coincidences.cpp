// Sections 6.2.2 to 7: the rule for ON cases, edges on edges, null edges in vertices, and why all
// tests must agree.
#include "tour/station.h"

namespace sectile::viewer {
namespace {

Figure rule(const char* normals, const char* who, const char* yes) {
  return Figure()
      .text(Ink::black, {50, 8}, "Table III: is the ON sector reclassified OUT?")
      .text(Ink::black, {28, 22}, normals)
      .text(Ink::black, {28, 30}, who)
      .text(Ink::grey, {62, 20}, "∪")
      .text(Ink::grey, {76, 20}, "\\")
      .text(Ink::grey, {90, 20}, "∩")
      .text(Ink::lit, {76, 31}, yes)
      .line(Ink::grey, {{6, 38}, {96, 38}});
}

Figure along_an_edge(const std::vector<FigurePoint>& a, const std::vector<FigurePoint>& b) {
  return Figure()
      .area(Ink::b, b)
      .area(Ink::a, a)
      .dot(Ink::lit, {50, 31})
      .text(Ink::a, {8, 8}, "A")
      .text(Ink::b, {92, 56}, "B");
}

Station table_3_identical_a() {
  return {"Table III, row 1: identical, A against B",
          {"Table III, row 1", "figure 18"},
          "fig18",
          Phase::vertex_vertex,
          "identical, A against B",
          "Figure 18: tops are flush, and an edge of each solid lies in the top of the other. A's "
          "ON sector has the normal of B's. For ∪ it counts as OUT, for \\ and ∩ as IN. It is as "
          "if A were a hair larger for ∪, and smaller otherwise.",
          Figure()
              .area(Ink::a, {{8, 54}, {58, 54}, {58, 22}, {8, 22}})
              .area(Ink::b, {{34, 46}, {92, 46}, {92, 22}, {34, 22}})
              .line(Ink::lit, {{34, 22}, {58, 22}}, 1.8f)
              .text(Ink::a, {20, 16}, "A1")
              .text(Ink::a, {64, 51}, "A2")
              .text(Ink::b, {76, 16}, "B2")
              .text(Ink::b, {28, 40}, "B1"),
          "For ∪, from which solid is the shared part of the top taken?",
          "From A: AonB+ goes to AoutB, and BonA+ to BinA."};
}

Station table_3_identical_b() {
  Station s{"Table III, row 2: identical, B against A",
            {"Table III, row 2"},
            "fig18",
            Phase::vertex_vertex,
            "identical, B against A",
            "The same plane, seen with B's edge in A's face. The rule must not be symmetric: what "
            "A keeps, B must drop. So for ∪ B's ON sector counts as IN, for \\ and ∩ as OUT: "
            "always the opposite of row 1.",
            rule("identical normals", "B against A", "no     yes    yes"),
            "What would go wrong if rows 1 and 2 were the same?",
            "The shared face would be kept twice or not at all."};
  return s;
}

Station table_3_opposite_a() {
  return {"Table III, row 3: opposite, A against B",
          {"Table III, row 3"},
          "table2-row3",
          Phase::vertex_vertex,
          "opposite, A against B",
          "With opposite normals the solids stand against each other. For ∪ the faces between "
          "them vanish: IN. For \\ A keeps its face: OUT. For ∩ nothing is there: OUT means that "
          "A's face is dropped with what lies outside B.",
          rule("opposite normals", "A against B", "no     yes    yes"),
          "Two blocks share a wall, one on each side. What is their intersection?",
          "Empty: the wall has no volume, and results are regular."};
}

Station table_3_opposite_b() {
  return {"Table III, row 4: opposite, B against A",
          {"Table III, row 4"},
          "fig12",
          Phase::vertex_vertex,
          "opposite, B against A",
          "Opposite normals once more, now with an edge of B in a face of A. Here A and B are "
          "treated alike, since nothing is shared that could be kept twice. The table's \\ column "
          "is wrong in the paper as printed, like that of Table I.",
          rule("opposite normals", "B against A", "no     yes    yes"),
          "For which operations is the rule true in rows 3 and 4?",
          "For \\ and ∩."};
}

Station figure_19() {
  return {"An edge on an edge",
          {"figure 19"},
          "fig19a",
          Phase::vertex_vertex,
          "Figure 19a",
          "Two edges coincide. Seen along their line four sectors leave it; sorted by angle they "
          "come as A B A B, in mixed order, or as A A B B. Mixed order means that the surfaces "
          "cross; otherwise they only touch.",
          along_an_edge({{50, 31}, {78, 58}, {78, 6}}, {{50, 31}, {96, 31}, {96, 60}, {50, 60}}),
          "In which order do the sectors come in the other picture of figure 19?",
          "A A B B: A lies beside B, and nothing is cut."};
}

Station figure_20() {
  return {"Ties",
          {"figure 20"},
          "fig20e",
          Phase::vertex_vertex,
          "Figure 20e",
          "Where sectors are coplanar, sorting meets a tie. Table I breaks it: the ON sector goes "
          "a hair to one side. Of the paper's five cases (a), (b) and (c) are not considered to "
          "intersect; (d) and (e), with opposite normals, are.",
          along_an_edge({{50, 31}, {78, 31}, {78, 6}, {22, 6}, {22, 58}, {78, 58}},
                        {{50, 31}, {96, 31}, {96, 60}, {50, 60}})
              .line(Ink::lit, {{50, 31}, {78, 31}}, 1.8f),
          "Which table breaks ties in the angular sort?",
          "Table I, once more: the ON sector is reclassified in or out."};
}

Station figure_21() {
  return {"The vertex falls apart",
          {"figure 21", "null_edges"},
          "fig21",
          Phase::null_edges,
          "Figure 21.",
          "Two coincident vertices; sectors of A cross sectors of B along the dashed lines. There "
          "both neighborhoods are divided, so that what is inside the other solid and what is "
          "outside have vertices of their own, joined by null edges.",
          Figure()
              .dot(Ink::black, {30, 32})
              .line(Ink::a, {{30, 32}, {10, 12}})
              .line(Ink::a, {{30, 32}, {50, 12}})
              .line(Ink::a, {{30, 32}, {30, 58}})
              .dashed(Ink::lit, {{30, 32}, {30, 8}})
              .dashed(Ink::lit, {{30, 32}, {52, 44}})
              .dot(Ink::black, {72, 24})
              .dot(Ink::black, {76, 38})
              .line(Ink::lit, {{72, 24}, {76, 38}}, 1.6f)
              .line(Ink::a, {{72, 24}, {54, 10}})
              .line(Ink::a, {{76, 38}, {94, 14}})
              .line(Ink::a, {{76, 38}, {74, 58}})
              .text(Ink::lit, {84, 32}, "null edge")
              .text(Ink::black, {30, 4}, "(a)")
              .text(Ink::black, {74, 4}, "(b)"),
          "How many null edges does a vertex with two cuts get?",
          "One: its ring falls into two runs."};
}

Station figure_22() {
  return {"A dangling null edge",
          {"figure 22"},
          "fig22",
          Phase::null_edges,
          "Figure 22.",
          "One sector may be crossed several times: here an arch stands with its tip in the corner "
          "of a block, and four cuts leave through one sector. Null edges make a chain; one of "
          "them dangles, with the same sector on both of its sides.",
          Figure()
              .dot(Ink::black, {36, 46})
              .line(Ink::a, {{36, 46}, {8, 20}})
              .line(Ink::a, {{36, 46}, {66, 20}})
              .dashed(Ink::lit, {{36, 46}, {26, 12}})
              .dashed(Ink::lit, {{36, 46}, {46, 12}})
              .line(Ink::lit, {{74, 46}, {86, 30}}, 1.6f)
              .dot(Ink::black, {74, 46})
              .dot(Ink::black, {86, 30})
              .text(Ink::lit, {84, 52}, "dangling"),
          "What does it mean that a null edge dangles?",
          "Both of its sides belong to the same face, until the cuts are joined."};
}

Station figure_23() {
  return {"All tests must agree",
          {"figure 23"},
          "fig23",
          Phase::vertex_face,
          "",
          "E1 passes E2 at less than the last bit of a double. P may lie in F1, in F2, or on E2, "
          "but not in two of them: if tests disagree, the algorithm fails. Here all tests are "
          "exact, so they cannot. The picture is enlarged a good deal.",
          Figure()
              .area(Ink::a, {{16, 52}, {50, 30}, {50, 8}, {16, 24}})
              .area(Ink::a, {{50, 30}, {88, 50}, {88, 22}, {50, 8}})
              .line(Ink::lit, {{28, 6}, {54, 20}, {84, 60}})
              .dot(Ink::black, {52, 19})
              .text(Ink::a, {26, 42}, "F1")
              .text(Ink::a, {78, 40}, "F2")
              .text(Ink::a, {50, 36}, "E2")
              .text(Ink::lit, {26, 12}, "E1")
              .text(Ink::black, {58, 16}, "P"),
          "By how much does E1 miss E2 in this scene?",
          "By 2⁻⁵⁰ / √2, about 6 · 10⁻¹⁶; the solids are four units wide."};
}

}  // namespace

std::vector<Station> stations_of_coincidences() {
  return {table_3_identical_a(), table_3_identical_b(), table_3_opposite_a(),
          table_3_opposite_b(),  figure_19(),           figure_20(),
          figure_21(),           figure_22(),           figure_23()};
}

}  // namespace sectile::viewer
