// An edge of A lies in a face or on an edge of B. A reaches farther than B at both of its ends, so
// that its edge enters and leaves B at coincident vertices and nothing else is coincident.
#include "samples/lists.h"
#include "samples/shapes.h"

namespace sectile::samples {

namespace {

using Profile = std::vector<Corner>;

/// A's edge at (4, 4), in the middle of B's top.
Sample in_face(const char* name, const char* title, Operation operation, const Profile& a) {
  return pair_sample(name, title, "16, 17, table II", operation, along_y(a, -1, 5),
                     block({0, 0, 0}, {8, 4, 4}));
}

/// A's edge at (0, 0), on B's upper left edge.
Sample on_edge(const char* name, const char* title, const char* figure, Operation operation,
               const Profile& a) {
  return pair_sample(name, title, figure, operation, along_y(a, -1, 5),
                     block({0, 0, -4}, {4, 4, 0}));
}

}  // namespace

std::vector<Sample> coincidence_figures() {
  constexpr Operation unite = Operation::unite, intersect = Operation::intersect,
                      subtract = Operation::subtract;
  return {
      in_face("table2-row1", "Edge in a face: ON and ON", unite, {{4, 2}, {6, 4}, {4, 4}, {2, 4}}),
      in_face("table2-row2", "Edge in a face: ON and IN", unite, {{2, 4}, {4, 2}, {4, 4}}),
      in_face("table2-row3", "Edge in a face: ON and OUT", unite, {{2, 4}, {4, 4}, {4, 6}}),
      in_face("table2-row4", "Edge in a face: IN and ON", intersect, {{4, 4}, {4, 2}, {6, 4}}),
      in_face("table2-row5", "Edge in a face: IN and IN", unite, {{4, 4}, {3, 2}, {5, 2}}),
      in_face("table2-row6", "Edge in a face: IN and OUT", unite, {{4, 4}, {2, 6}, {2, 2}}),
      in_face("table2-row7", "Edge in a face: OUT and ON", subtract, {{4, 4}, {6, 4}, {4, 6}}),
      in_face("table2-row8", "Edge in a face: OUT and IN", subtract, {{4, 4}, {6, 2}, {6, 6}}),
      in_face("table2-row9", "Edge in a face: OUT and OUT", unite, {{4, 4}, {5, 6}, {3, 6}}),
      pair_sample("fig18", "Flush tops, an edge of each in the other", "18", unite,
                  block({0, -1, 0}, {4, 5, 4}), block({2, 0, 1}, {6, 4, 4})),
      on_edge("fig19a", "Edge on an edge, in mixed order", "19a", unite, {{0, 0}, {2, -2}, {2, 2}}),
      on_edge("fig19b", "Edge on an edge, apart", "19b", unite, {{0, 0}, {1, 2}, {-1, 2}}),
      on_edge("fig20a-identical", "All sectors coplanar, same side", "20a", unite,
              {{0, 0}, {0, -2}, {2, -2}, {2, 0}}),
      on_edge("fig20a-opposite", "All sectors coplanar, opposite sides", "20a", unite,
              {{0, 0}, {2, 0}, {2, 2}, {-2, 2}, {-2, -2}, {0, -2}}),
      on_edge("fig20b", "One coplanar pair, same side, A narrower", "20b", unite,
              {{0, 0}, {2, -2}, {2, 0}}),
      on_edge("fig20c", "One coplanar pair, same side, A wider", "20c", unite,
              {{0, 0}, {-2, -2}, {2, -2}, {2, 0}}),
      on_edge("fig20d", "One coplanar pair, opposite sides, apart", "20d", unite,
              {{0, 0}, {2, 0}, {2, 2}}),
      on_edge("fig20e", "One coplanar pair, opposite sides, overlapping", "20e", unite,
              {{0, 0}, {2, 0}, {2, 2}, {-2, 2}, {-2, -2}, {2, -2}}),
  };
}

}  // namespace sectile::samples
