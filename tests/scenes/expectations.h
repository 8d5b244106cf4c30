#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

namespace sectile::expectations {

enum class Result { unite, intersect, subtract, subtract_from, above, below };

struct Counts {
  std::size_t vertices, edges, faces, loops, shells;
  std::int64_t genus;
};

struct Row {
  Result result;
  Counts counts;
  double volume, area;
};

struct Figure {
  const char* sample;
  const char* why;
  std::vector<Row> rows;
};

inline const double r2 = std::sqrt(2.0), r5 = std::sqrt(5.0), r6 = std::sqrt(6.0),
                    r34 = std::sqrt(34.0), r66 = std::sqrt(66.0);
inline constexpr double tiny = 0x1p-50;
inline const double tiny_tip = 2 * tiny * tiny * tiny / (3 * (4 + tiny));
inline constexpr Counts nothing{0, 0, 0, 0, 0, 0};

inline const std::vector<Figure>& figures() {
  using enum Result;
  static const std::vector<Figure> table{
      {"fig01",
       "A's L (area 10) against B's U (area 8). A and B is the L with the channel y 1..3 above z "
       "1: "
       "walls x = 0 and x = 4 are one U each, ends one L each, step, riser and top fall in two, "
       "the "
       "channel adds two L walls and its floor: 14 faces, 24 corners of three edges. A or B is the "
       "4x4x3 block with a pocket x 2..4, y 1..3, z 2..3 open at the top and at x = 4; A's faces "
       "stay whole and B's tops, ends and sides keep their rest. A less B is A's L over y 1..3 "
       "above z 1. B less A is two bricks 2x1x1.",
       {{unite, {22, 36, 16, 16, 1, 0}, 44, 84},
        {intersect, {24, 36, 14, 14, 1, 0}, 28, 80},
        {subtract, {12, 18, 8, 8, 1, 0}, 12, 36},
        {subtract_from, {16, 24, 12, 12, 2, 0}, 4, 20}}},
      {"fig02",
       "The front of the block less the triangle is an octagon that passes the apex twice: a prism "
       "with 8 corners, two coincident apex edges, one for each wedge of material. The wedge lies "
       "in the block, so the union is the block and the intersection the wedge.",
       {{unite, {8, 12, 6, 6, 1, 0}, 24, 52},
        {intersect, {6, 9, 5, 5, 1, 0}, 4, 8 + 4 * r5},
        {subtract, {16, 24, 10, 10, 1, 0}, 20, 52 + 4 * r5},
        {subtract_from, nothing, 0, 0}}},
      {"fig03",
       "A is the result of figure 2 with its ends in three quadrilaterals each: 16 corners, 24 + 4 "
       "edges, 10 + 4 faces. Filled with the wedge, the tunnel's faces vanish; the two tops are "
       "different faces of A and keep the apex edge between them, now one; each end keeps A's "
       "three parts and B's triangle: 5 + 2 * 4 faces, 8 + 2 + 4 corners.",
       {{unite, {14, 25, 13, 13, 1, 0}, 24, 52},
        {intersect, nothing, 0, 0},
        {subtract, {16, 28, 14, 14, 1, 0}, 20, 52 + 4 * r5},
        {subtract_from, {6, 9, 5, 5, 1, 0}, 4, 8 + 4 * r5}}},
      {"fig04",
       "Above: two triangular prisms. Below: a block 6x2x2 whose top is in three parts, the notch "
       "floor and two caps: two more edges across and two more corners in front and behind.",
       {{above, {12, 18, 10, 10, 2, 0}, 8, 24 + 8 * r2}, {below, {12, 18, 8, 8, 1, 0}, 24, 56}}},
      {"fig11",
       "Each brick loses one corner and three faces get a bite; six points of intersection.",
       {{unite, {20, 30, 12, 12, 1, 0}, 120, 168},
        {intersect, {8, 12, 6, 6, 1, 0}, 8, 24},
        {subtract, {14, 21, 9, 9, 1, 0}, 56, 96},
        {subtract_from, {14, 21, 9, 9, 1, 0}, 56, 96}}},
      {"fig12",
       "Union: A's front stays whole (equal normals), A's top loses the footprint 4x2, B adds "
       "front, top, left, right and back above z 2: 6 + 5 faces, 8 + 4 + 4 corners. Intersection: "
       "the leg 1x2x1. A less B: a slot for the leg in top and front. B less A: B above z 2, a "
       "brick 4x2x2 whose bottom is in two parts, B's own under x 2..5 and A's top turned under "
       "the leg.",
       {{unite, {16, 25, 11, 11, 1, 0}, 64, 112},
        {intersect, {8, 12, 6, 6, 1, 0}, 2, 10},
        {subtract, {16, 24, 10, 10, 1, 0}, 46, 92},
        {subtract_from, {10, 15, 7, 7, 1, 0}, 16, 40}}},
      {"fig13",
       "The plane of the top cuts the tetrahedron in the triangle apex, (2,3,4), (2,5,4) of area "
       "2. Union: a pyramid of three faces on an inner loop of the top. A less B: a pocket of four "
       "faces under it. The parts of the tetrahedron above and below are 4/3 and 4.",
       {{unite, {12, 18, 9, 10, 1, 0}, 256 + 4.0 / 3, 256 + 2 * r6},
        {intersect, {5, 8, 5, 5, 1, 0}, 4, 8 + 4 * r2 + 2 * r6},
        {subtract, {13, 20, 10, 11, 1, 0}, 252, 260 + 4 * r2 + 2 * r6},
        {subtract_from, {4, 6, 4, 4, 1, 0}, 4.0 / 3, 4 + 2 * r6}}},
      {"table2-row1",
       "A's profile hangs with its split top in B's top (equal normals): A's two tops stay whole, "
       "B's top keeps two strips, B's front and back a heptagon each, A's slants and ends stand "
       "out at both sides.",
       {{unite, {22, 35, 15, 15, 1, 0}, 136, 168 + 8 * r2},
        {intersect, {8, 12, 6, 6, 1, 0}, 16, 24 + 16 * r2},
        {subtract, {16, 24, 12, 12, 2, 0}, 8, 24 + 8 * r2},
        {subtract_from, {14, 21, 9, 9, 1, 0}, 112, 136 + 16 * r2}}},
      {"table2-row2",
       "As row 1, with a triangle whose top is one face.",
       {{unite, {20, 32, 14, 14, 1, 0}, 132, 168 + 4 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {12, 18, 10, 10, 2, 0}, 4, 16 + 4 * r2},
        {subtract_from, {14, 21, 9, 9, 1, 0}, 120, 156 + 8 * r2}}},
      {"table2-row3",
       "A stands on B (opposite normals): A's bottom keeps two overhangs, B's top two strips; "
       "front and back stay whole, with two more corners each.",
       {{unite, {18, 29, 13, 13, 1, 0}, 140, 172 + 12 * r2},
        {intersect, nothing, 0, 0},
        {subtract, {6, 9, 5, 5, 1, 0}, 12, 28 + 12 * r2},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 128, 160}}},
      {"table2-row4",
       "The mirror image of row 2.",
       {{unite, {20, 32, 14, 14, 1, 0}, 132, 168 + 4 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {12, 18, 10, 10, 2, 0}, 4, 16 + 4 * r2},
        {subtract_from, {14, 21, 9, 9, 1, 0}, 120, 156 + 8 * r2}}},
      {"table2-row5",
       "A's upper edge touches B's top from within: the top stays whole, front and back pass the "
       "apex twice, and A stands out with two slants and an end at both sides. B less A has two "
       "coincident edges as in figure 2.",
       {{unite, {20, 32, 14, 14, 1, 0}, 132, 164 + 4 * r5},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 12 + 8 * r5},
        {subtract, {12, 18, 10, 10, 2, 0}, 4, 12 + 4 * r5},
        {subtract_from, {16, 24, 10, 10, 1, 0}, 120, 164 + 8 * r5}}},
      {"table2-row6",
       "A leaves B through its top. Union: A's upper slant is whole, its wall a U, the lower slant "
       "in two; B's top in two strips. A less B: two ends, upper slant, U, two lower slants and "
       "three faces of B turned.",
       {{unite, {20, 31, 13, 13, 1, 0}, 144, 172 + 16 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {12, 19, 9, 9, 1, 0}, 16, 36 + 16 * r2},
        {subtract_from, {14, 21, 9, 9, 1, 0}, 120, 156 + 8 * r2}}},
      {"table2-row7",
       "The mirror image of row 3.",
       {{unite, {18, 29, 13, 13, 1, 0}, 140, 172 + 12 * r2},
        {intersect, nothing, 0, 0},
        {subtract, {6, 9, 5, 5, 1, 0}, 12, 28 + 12 * r2},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 128, 160}}},
      {"table2-row8",
       "The mirror image of row 6.",
       {{unite, {20, 31, 13, 13, 1, 0}, 144, 172 + 16 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {12, 19, 9, 9, 1, 0}, 16, 36 + 16 * r2},
        {subtract_from, {14, 21, 9, 9, 1, 0}, 120, 156 + 8 * r2}}},
      {"table2-row9",
       "A's lower edge touches B's top from outside: two shells that touch, nothing is cut.",
       {{unite, {14, 21, 11, 11, 2, 0}, 140, 176 + 12 * r5},
        {intersect, nothing, 0, 0},
        {subtract, {6, 9, 5, 5, 1, 0}, 12, 16 + 12 * r5},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 128, 160}}},
      {"fig18",
       "Union: A's top stays whole, its right wall gets a bite; B keeps the rest of top, bottom, "
       "ends and its right wall. Intersection and B less A: bricks 2x4x3. A less B: the top and "
       "the right wall get a bite, four faces of B line it.",
       {{unite, {16, 25, 11, 11, 1, 0}, 120, 156},
        {intersect, {8, 12, 6, 6, 1, 0}, 24, 52},
        {subtract, {16, 24, 10, 10, 1, 0}, 72, 140},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 24, 52}}},
      {"fig19a",
       "As row 6, with B's own corner instead of its top's middle: one strip of B's top is left "
       "and "
       "the edge's points are B's corners.",
       {{unite, {18, 28, 12, 12, 1, 0}, 80, 108 + 16 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {12, 19, 9, 9, 1, 0}, 16, 36 + 16 * r2},
        {subtract_from, {12, 18, 8, 8, 1, 0}, 56, 92 + 8 * r2}}},
      {"fig19b",
       "Two wedges of material share the line: two shells that touch.",
       {{unite, {14, 21, 11, 11, 2, 0}, 76, 112 + 12 * r5},
        {intersect, nothing, 0, 0},
        {subtract, {6, 9, 5, 5, 1, 0}, 12, 16 + 12 * r5},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 64, 96}}},
      {"fig20a-identical",
       "Union: A's top and left wall stay whole, its bottom and right wall keep two parts each; B "
       "keeps the rest of its top and left wall, and L-shaped ends.",
       {{unite, {20, 32, 14, 14, 1, 0}, 72, 112},
        {intersect, {8, 12, 6, 6, 1, 0}, 16, 40},
        {subtract, {16, 24, 12, 12, 2, 0}, 8, 32},
        {subtract_from, {12, 18, 8, 8, 1, 0}, 48, 88}}},
      {"fig20a-opposite",
       "B fills the missing quarter of A: of the two faces of A there, two ends each are left.",
       {{unite, {24, 38, 16, 16, 1, 0}, 136, 184},
        {intersect, nothing, 0, 0},
        {subtract, {12, 18, 8, 8, 1, 0}, 72, 120},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 64, 96}}},
      {"fig20b",
       "A's top, equal to B's, stays whole; its slant and wall keep two ends each.",
       {{unite, {18, 29, 13, 13, 1, 0}, 68, 104 + 4 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {12, 18, 10, 10, 2, 0}, 4, 16 + 4 * r2},
        {subtract_from, {12, 18, 8, 8, 1, 0}, 56, 92 + 8 * r2}}},
      {"fig20c",
       "A's top and slant stay whole in the union, its bottom gets a bite, its right wall keeps "
       "two "
       "ends. A less B: the top falls in two, three faces of B line the bite.",
       {{unite, {20, 31, 13, 13, 1, 0}, 84, 116 + 12 * r2},
        {intersect, {8, 12, 6, 6, 1, 0}, 16, 40},
        {subtract, {16, 25, 11, 11, 1, 0}, 20, 52 + 12 * r2},
        {subtract_from, {12, 18, 8, 8, 1, 0}, 48, 88}}},
      {"fig20d",
       "A stands on B's top with its edge on B's edge: A's bottom keeps two overhangs, B's top one "
       "strip.",
       {{unite, {16, 26, 12, 12, 1, 0}, 76, 108 + 12 * r2},
        {intersect, nothing, 0, 0},
        {subtract, {6, 9, 5, 5, 1, 0}, 12, 28 + 12 * r2},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 64, 96}}},
      {"fig20e",
       "A stands on B's top and reaches round into B: the groove between is filled over B's depth. "
       "A less B: only slant and bottom are cut, three faces of B line the bite.",
       {{unite, {26, 40, 16, 16, 1, 0}, 140, 184 + 4 * r2},
        {intersect, {6, 9, 5, 5, 1, 0}, 8, 20 + 8 * r2},
        {subtract, {18, 28, 12, 12, 1, 0}, 76, 128 + 4 * r2},
        {subtract_from, {12, 18, 8, 8, 1, 0}, 56, 92 + 8 * r2}}},
      {"fig21",
       "B is a pyramid of volume 64/3 round A's edge, a quarter of it in A. Union: A keeps 6 "
       "faces, B all 5, two of them halved and the base an L. A less B: a notch of three faces.",
       {{unite, {14, 23, 11, 11, 1, 0}, 528, 388 + 12 * r5},
        {intersect, {5, 8, 5, 5, 1, 0}, 16.0 / 3, 12 + 4 * r5},
        {subtract, {12, 19, 9, 9, 1, 0}, 512 - 16.0 / 3, 380 + 4 * r5},
        {subtract_from, {7, 12, 7, 7, 1, 0}, 16, 20 + 12 * r5}}},
      {"fig22",
       "The cone over the arch (area 18, 8 of it in the legs below A's top) has volume 48, 64/3 "
       "below. Union: the tunnel under the arch reaches the apex, so there are two vertices. "
       "Intersection: the two legs, touching in the apex. A less B: two pockets of four faces.",
       {{unite, {17, 28, 13, 13, 1, 0}, 512 + 80.0 / 3, 368 + 38 * r2 + r66 + r34},
        {intersect, {10, 16, 10, 10, 2, 0}, 64.0 / 3, 16 + 30 * r2 + 2 * r34},
        {subtract, {16, 28, 14, 14, 1, 0}, 512 - 64.0 / 3, 368 + 30 * r2 + 2 * r34},
        {subtract_from, {9, 16, 9, 9, 1, 0}, 80.0 / 3, 16 + 38 * r2 + r66 + r34}}},
      {"fig23",
       "B's edge leaves A's top 2^-50 before A's edge and A's side as far below it: four points of "
       "intersection, a tetrahedron in common whose faces are triangles of that size.",
       {{unite, {16, 24, 10, 10, 1, 0}, 64 + 32.0 / 3, 112 + 8 * r6},
        {intersect, {4, 6, 4, 4, 1, 0}, tiny_tip, tiny * tiny * (1 + r6 / 2)},
        {subtract, {12, 18, 8, 8, 1, 0}, 64, 96},
        {subtract_from, {8, 12, 6, 6, 1, 0}, 32.0 / 3, 16 + 8 * r6}}},
      {"fig23-touching",
       "The two edges cross in one point and nothing else meets: two shells.",
       {{unite, {12, 18, 10, 10, 2, 0}, 64 + 32.0 / 3, 112 + 8 * r6},
        {intersect, nothing, 0, 0},
        {subtract, {8, 12, 6, 6, 1, 0}, 64, 96},
        {subtract_from, {4, 6, 4, 4, 1, 0}, 32.0 / 3, 16 + 8 * r6}}},
  };
  return table;
}

}  // namespace sectile::expectations
