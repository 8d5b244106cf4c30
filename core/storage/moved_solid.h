// The exact image of a solid. A move costs next to nothing; the points of the image are made when
// they are first asked for, block by block. The faces are those of the original, and shared with
// it.
#pragma once

#include <memory>

#include "geometry/frame.h"
#include "parallel/once_alone.h"
#include "storage/solid_data.h"

namespace sectile {

class MovedSolid {
 public:
  MovedSolid(std::shared_ptr<const SolidData> original, Frame frame)
      : original_(std::move(original)), frame_(std::move(frame)) {}

  const std::shared_ptr<const SolidData>& original() const { return original_; }
  const Frame& frame() const { return frame_; }
  const std::shared_ptr<const SolidData>& image() const;

 private:
  std::shared_ptr<const SolidData> original_;
  Frame frame_;
  mutable OnceFlag once_;
  mutable std::shared_ptr<const SolidData> image_;
};

}  // namespace sectile
