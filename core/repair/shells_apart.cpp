#include "repair/shells_apart.h"

#include <atomic>

#include "parallel/parallel.h"
#include "search/face_tree.h"

namespace sectile {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

class ShellTrees {
 public:
  ShellTrees(const Brep& brep, const Geometry& geometry, const Shells& shells)
      : boxes_(shells.count), trees_(shells.count) {
    std::vector<std::vector<Box>> faces(shells.count);
    for (const FaceId f : brep.faces())
      faces[shells.of_face[f.value()]].push_back(face_box(brep, geometry, f));
    parallel::loop(0, faces.size(), [&](std::size_t s) {
      for (const Box& b : faces[s]) boxes_[s].add(b);
      trees_[s] = BoxTree(faces[s]);
    });
  }

  bool are_apart() const {
    const Pairs near = near_shells();
    std::atomic<bool> apart = true;
    parallel::loop(0, near.size(), [&](std::size_t i) {
      BoxTree::overlaps(
          trees_[near[i].first], trees_[near[i].second],
          [&](std::uint32_t, std::uint32_t) { apart = false; },
          [](std::uint32_t, std::uint32_t) { return false; },
          [&](BoxTree::Node, BoxTree::Node) { return !apart; });
    });
    return apart;
  }

 private:
  Pairs near_shells() const {
    Pairs near;
    const BoxTree all(boxes_);
    for (const BoxTree::SelfPart& part : all.self_parts(1))
      all.self_overlaps(part, [&](std::uint32_t s, std::uint32_t t) { near.push_back({s, t}); });
    return near;
  }

  std::vector<Box> boxes_;  // per shell
  std::vector<BoxTree> trees_;
};

}  // namespace

bool shells_are_apart(const Brep& brep, const Geometry& geometry, const Shells& shells) {
  return shells.count == 1 || ShellTrees(brep, geometry, shells).are_apart();
}

}  // namespace sectile
