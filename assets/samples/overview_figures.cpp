#include "samples/lists.h"
#include "samples/shapes.h"

namespace sectile::samples {

namespace {

// A step in one profile, a notch in the other; bottoms, tops and all four side walls are flush.
Sample extruded_profiles() {
  return pair_sample(
      "fig01", "Two extruded profiles", "1", Operation::intersect,
      along_y({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 3}, {0, 3}}, 0, 4),
      along_x({{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}, 0, 4));
}

// The apex edge of the wedge lies in the top of the block.
Sample touching_tunnel() {
  return pair_sample("fig02", "A tunnel that touches the top", "2, 3", Operation::subtract,
                     block({0, 0, 0}, {4, 2, 3}), along_y({{1, 1}, {3, 1}, {2, 3}}, 0, 2));
}

// The result of figure 2 as an operand: its profile passes the apex twice, so there are two edges
// at one place. The ends are three quadrilaterals each, none of which touches itself.
Sample pseudomanifold_operand() {
  return pair_sample("fig03", "A pseudomanifold filled again", "3", Operation::unite,
                     along_y({{0, 0}, {4, 0}, {4, 3}, {2, 3}, {3, 1}, {1, 1}, {2, 3}, {0, 3}},
                             {{0, 1, 4, 5}, {1, 2, 3, 4}, {0, 5, 6, 7}}, 0, 2),
                     along_y({{1, 1}, {3, 1}, {2, 3}}, 0, 2));
}

Sample split_prongs() {
  Sample sample;
  sample.name = "fig04";
  sample.title = "A block with two prongs, split at the notch floor";
  sample.figure = "4 to 10";
  sample.a_mesh = along_y({{0, 0}, {6, 0}, {6, 4}, {4, 2}, {2, 2}, {0, 4}}, 0, 2);
  sample.a = solid_of(sample.a_mesh);
  sample.plane = HalfSpace{0, 0, 1, -2};
  return sample;
}

Sample two_bricks() {
  return pair_sample("fig11", "Two bricks, a corner of each in the other", "11", Operation::unite,
                     block({0, 0, 0}, {4, 4, 4}), block({2, 2, 2}, {6, 6, 6}));
}

// B stands on A's top (opposite normals) with its leg let into A, flush in front (equal normals).
Sample let_in_block() {
  return pair_sample("fig12", "A block that stands on a block, partly let in", "12",
                     Operation::unite, block({0, 0, 0}, {6, 4, 2}),
                     along_y({{1, 1}, {2, 1}, {2, 2}, {5, 2}, {5, 4}, {1, 4}}, 0, 2));
}

// The tetrahedron's apex lies inside the top; one of its edges goes up from there, two go down.
Sample vertex_in_face() {
  return pair_sample("fig13", "A vertex inside a face", "13", Operation::subtract,
                     block({0, 0, 0}, {8, 8, 4}),
                     cone({4, 4, 4}, {{2, 2, 2}, {2, 4, 6}, {2, 6, 2}}));
}

}  // namespace

std::vector<Sample> overview_figures() {
  return {extruded_profiles(), touching_tunnel(), pseudomanifold_operand(), split_prongs(),
          two_bricks(),        let_in_block(),    vertex_in_face()};
}

}  // namespace sectile::samples
