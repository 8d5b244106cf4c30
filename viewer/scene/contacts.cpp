// The placements of solids that were dragged into contact.
#include <glm/glm.hpp>

#include "scene/snapping.h"
#include "scene/transforms.h"

namespace sectile::viewer {

namespace {

/// Does a move mean the same in both?
bool are_turned_alike(const ExactTransform& a, const ExactTransform& b) {
  const Transform p = a.nearest(), q = b.nearest();
  for (std::size_t i = 0; i < 12; ++i)
    if (i % 4 != 3 && p.m[i] != q.m[i]) return false;
  return true;
}

class Drag {
 public:
  Drag(const std::vector<DraggedNode>& nodes, const Vec3& offset) : nodes_(nodes) {
    for (const DraggedNode& node : nodes) {
      const glm::dvec3 own = glm::dmat3(matrix_of(inverse(node.parent.nearest()))) * to_glm(offset);
      shifts_.push_back({from_glm(own), {0, 0, 0}});
    }
  }

  void make(const Snap& contact) {
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (const std::optional<ExactTransform>& way = nodes_[i].ways.at(contact.part))
        shift(i, moved_onto(placement(i), nodes_[i].parent, own(contact, i, *way),
                            target_of(contact), contact.fixed)
                     .placement);
  }

  Placement placement(std::size_t node) const { return shifted(nodes_[node].start, shifts_[node]); }

  /// Do all corners of the contact lie where it wants them?
  bool is_exact(const Snap& contact) const {
    if (!contact.is_expressible) return false;
    const ExactSum target = target_of(contact);
    for (const ExactCorner& corner : contact.on)
      if (!are_equal({contact.on_place, corner}, target, contact.fixed)) return false;
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (const std::optional<ExactTransform>& way = nodes_[i].ways.at(contact.part))
        for (const ExactCorner& corner : contact.moved)
          if (!are_equal({nodes_[i].parent * placement(i).exact() * *way, corner}, target,
                         contact.fixed))
            return false;
    return true;
  }

 private:
  /// The corner that comes onto the target, in the node's own coordinates.
  ExactSum own(const Snap& contact, std::size_t node, const ExactTransform& way) const {
    if (!contact.moved.empty()) return {way, contact.moved.front()};
    const Transform before =
        nodes_[node].parent.nearest() * nodes_[node].start.transform() * way.nearest();
    return {way, {inverse(before)(contact.from)}};
  }

  static ExactSum target_of(const Snap& contact) {
    return contact.on.empty() ? ExactSum::of(contact.to)
                              : ExactSum(contact.on_place, contact.on.front());
  }

  void shift(std::size_t node, const Placement& to) {
    const Shift made = shift_between(nodes_[node].start, to);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (i == node || are_turned_alike(nodes_[i].parent, nodes_[node].parent)) shifts_[i] = made;
  }

  const std::vector<DraggedNode>& nodes_;
  std::vector<Shift> shifts_;
};

}  // namespace

Landings placed_by(const std::vector<DraggedNode>& nodes, const Vec3& offset,
                   const std::vector<Snap>& contacts) {
  Drag drag(nodes, contacts.empty() ? offset : contacts.back().offset);
  for (const Snap& contact : contacts) drag.make(contact);
  Landings made{{}, true};
  for (std::size_t i = 0; i < nodes.size(); ++i) made.placements.push_back(drag.placement(i));
  for (const Snap& contact : contacts) made.is_exact = made.is_exact && drag.is_exact(contact);
  return made;
}

}  // namespace sectile::viewer
