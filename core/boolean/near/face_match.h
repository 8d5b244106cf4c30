// Is a face of one solid a face of another one, corner by corner?
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "boolean/tables.h"
#include "storage/face_at.h"
#include "storage/solid_data.h"

namespace sectile {

/// Not for several threads at a time.
class FaceMatch {
 public:
  FaceMatch(const SolidData& a, const SolidData& b) : a_(a), b_(b) {}

  /// Do they run the same way around their corners? None if these are not the same, as far as their
  /// definitions tell, or if a loop comes to one place twice.
  std::optional<Class> operator()(const FaceAt& of_a, const FaceAt& of_b);

 private:
  using Loop = std::vector<PointId>;

  static void load(const Slot& slot, FaceId face, std::vector<Loop>& loops);
  std::optional<Class> compare(const Block& a, const Loop& of_a, const Block& b, const Loop& of_b);
  bool are_same(const Block& a, PointId p, const Block& b, PointId q);
  bool are_same(const Frame& p, const Frame& q);

  const SolidData &a_, &b_;
  std::vector<Loop> loops_of_a_, loops_of_b_;
  // One pair of frames comes again and again.
  std::pair<const Frame*, const Frame*> known_frames_;
  bool known_same_ = false;
};

}  // namespace sectile
