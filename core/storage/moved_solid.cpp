#include "storage/moved_solid.h"

#include "geometry/moved_geometry.h"
#include "parallel/parallel.h"

namespace sectile {
namespace {

std::shared_ptr<const SolidData> moved(const SolidData& solid, const Frame& frame) {
  const auto mover = std::make_shared<GeometryMover>(frame);
  for (const Slot& slot : solid.slots())
    if (!slot.empty()) mover->prepare(slot.block->geometry());
  std::vector<Slot> slots(solid.slots().begin(), solid.slots().end());
  // A mirrored half-edge has its face on the other side.
  const bool mirrors = frame.determinant().sign() == Sign::negative;
  parallel::loop(0, slots.size(), [&](std::size_t i) {
    Slot& slot = slots[i];
    if (slot.empty()) return;
    slot.block = std::make_shared<const Block>(slot.block, mover);
    slot.turned = slot.turned != mirrors;
  });
  auto image = std::make_shared<SolidData>(std::move(slots), solid.touches_itself());
  image->origin = solid.origin;
  return image;
}

}  // namespace

const std::shared_ptr<const SolidData>& MovedSolid::image() const {
  once_alone(once_, [this] { image_ = moved(*original_, frame_); });
  return image_;
}

}  // namespace sectile
