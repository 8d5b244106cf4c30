// The faces of a solid that rays in direction +x may meet, near ones first.
//
// For many rays: each goes through what is near its start only, if it can end there. Where boxes
// say little, oriented ones are made as soon as that takes no longer than what was done already.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "search/oriented_tree.h"
#include "search/outline_across_x.h"
#include "search/x_ray_bounds.h"
#include "storage/solid_data.h"

namespace sectile {

class FacesOnRay {
 public:
  explicit FacesOnRay(const SolidData& solid);

  /// Begins a ray at a place that is known up to half an ulp in each coordinate.
  void start(const Vec3& from);
  /// Is there nothing more on the ray?
  bool at_end() const { return front_.empty(); }
  /// What is to come is met at no smaller x.
  double begin() const {
    return at_end() ? std::numeric_limits<double>::infinity() : front_.front().from;
  }

  /// A face that the ray may meet, not farther than at some x.
  struct Met {
    FaceId face;
    double to;
    /// If the ray certainly meets the face, the sign of the x of its normal in the solid.
    Sign normal;
  };
  /// Goes one step on.
  std::optional<Met> next();

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  // What comes next: a node of the tree of slots, a slot, a node of its tree, or a face of it; one
  // of many corners was not looked at yet.
  struct Entry {
    enum class Kind : std::uint8_t { slots, slot, faces, face, large_face } kind;
    Sign normal = Sign::zero;  // of a face that is met, if at all
    std::uint32_t slot = none;
    std::uint32_t level = 0, index = 0;  // of a node; of a face
    double from = 0, to = 0;

    friend bool operator<(const Entry& a, const Entry& b) { return a.from > b.from; }
  };
  // What is found out about a block that very many rays went through.
  struct OfSlot {
    std::size_t steps = 0;  // that were done in it
    bool is_ready = false;
    const OrientedTree* oriented = nullptr;  // if boxes say little
    /// Per face, for those of many corners; empty if there is none.
    std::vector<std::unique_ptr<const OutlineAcrossX>> outlines;
  };

  void push(Entry entry, double from);
  void enter_slots(const Entry& entry);
  void enter_slot(const Entry& entry);
  void enter_faces(const Entry& entry);
  void add_slots(BoxTree::Node node, double from);
  void add_faces(std::uint32_t slot, BoxTree::Node node, double from);
  void add_face(std::uint32_t slot, FaceId local, double from);
  std::optional<Met> look_at(const Entry& face);
  std::optional<bool> is_met(const Entry& large_face);

  OfSlot& of(std::uint32_t slot) { return of_slot_[slot]; }
  const Block& block(std::uint32_t slot) const { return *solid_.slot(slot).block; }
  void take_steps(std::uint32_t slot, std::size_t steps);
  void prepare(std::uint32_t slot);
  void prepare_slots();

  const SolidData& solid_;
  std::vector<OfSlot> of_slot_;
  std::size_t steps_ = 0;  // in the tree of slots
  std::optional<OrientedTree> oriented_;
  // Of the ray.
  std::optional<XRayBounds> ray_;
  std::vector<Entry> front_;  // a heap
  std::size_t slots_entered_ = 0;
};

}  // namespace sectile
