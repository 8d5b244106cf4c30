#include "import/measure.h"

#include <cmath>
#include <optional>

namespace sectile {
namespace {

// value / divisor, off by less than two units in the last place, if the error is known to be below
// a sixteenth of one.
std::optional<double> certain(const Bounded& value, double divisor) {
  if (!(value.error() <= std::abs(value.high()) * 0x1p-57)) return std::nullopt;
  const double first = value.high() / divisor;
  if (!(std::abs(first) > 0x1p-900 && std::abs(first) < 0x1p1000)) return std::nullopt;
  return first + (std::fma(-first, divisor, value.high()) + value.low()) / divisor;
}

bool has_faces(const Slot& slot) {
  return !slot.empty() && slot.block->face_count() > 0;
}

// What the blocks know is found on all cores, and then summed in the order of the slots.
template <class Find, class Add>
void for_each_block(const SolidData& solid, const Find& find, const Add& add) {
  const auto slots = solid.slots();
  parallel::loop(0, slots.size(), [&](std::size_t s) {
    if (has_faces(slots[s])) find(*slots[s].block);
  });
  for (const Slot& slot : slots)
    if (has_faces(slot)) add(slot);
}

}  // namespace

Bounded six_volumes_of(const SolidData& solid) {
  Bounded six_volumes;
  std::optional<double> level;
  for_each_block(
      solid, [](const Block& block) { block.volume(); },
      [&](const Slot& slot) {
        const BlockVolume& own = slot.block->volume();
        if (!level) level = own.level;
        const Bounded volume =
            own.below + own.shadow * (Bounded(3) * Bounded::difference(own.level, *level));
        six_volumes = six_volumes + (slot.turned ? -volume : volume);
      });
  return six_volumes;
}

Bounded two_areas_of(const SolidData& solid) {
  Bounded two_areas;
  for_each_block(
      solid, [](const Block& block) { block.two_areas(); },
      [&](const Slot& slot) { two_areas = two_areas + slot.block->two_areas(); });
  return two_areas;
}

double volume_of(const SolidData& solid) {
  const auto known = certain(six_volumes_of(solid), 6);
  return known ? *known : exact_volume(solid);
}

double area_of(const SolidData& solid) {
  const auto known = certain(two_areas_of(solid), 2);
  return known ? *known : exact_area(solid);
}

double area_of(std::span<const SomeFaces> parts) {
  Bounded two_areas;
  for (const SomeFaces& part : parts)
    two_areas = two_areas + two_areas_of_faces(part.brep, part.geometry, part.faces);
  if (std::ranges::all_of(parts, [](const SomeFaces& part) { return part.faces.empty(); }))
    return 0;
  const auto known = certain(two_areas, 2);
  return known ? *known : exact_area(parts);
}

}  // namespace sectile
