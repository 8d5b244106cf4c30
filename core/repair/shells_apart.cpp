#include "repair/shells_apart.h"

#include "parallel/parallel.h"
#include "search/face_tree.h"

namespace sectile {
namespace {

// Once two shells are near each other there is nothing more to be found out.
struct UntilNear : BoxTree::NothingApart {
  const bool& apart;
  bool nodes(BoxTree::Node, BoxTree::Node) const { return !apart; }
};

}  // namespace

// Whole nodes of one shell are passed over: what is looked into is where shells are near others.
bool shells_are_apart(const Brep& brep, const Geometry& geometry, const Shells& shells) {
  if (shells.count == 1) return true;
  std::vector<Box> boxes(brep.face_count());
  parallel::loop(parallel::Range<std::size_t>(0, boxes.size(), 2048), [&](const auto& range) {
    for (std::size_t f = range.begin(); f < range.end(); ++f)
      boxes[f] = face_box(brep, geometry, FaceId(f));
  });
  const BoxTree tree(boxes, shells.of_face);
  bool apart = true;
  BoxTree::overlaps(
      tree, tree, [&](std::uint32_t, std::uint32_t) { apart = false; },
      [](std::uint32_t shell, std::uint32_t other) { return shell == other; },
      UntilNear{{}, apart});
  return apart;
}

}  // namespace sectile
