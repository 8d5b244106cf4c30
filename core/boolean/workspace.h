// What all phases of one operation work on: the loaded parts of both operands, and one geometry.
#pragma once

#include <atomic>
#include <memory>

#include "boolean/records.h"
#include "geometry/kernel.h"
#include "sectile/boolean.h"
#include "sectile/errors.h"

namespace sectile {

struct Workspace {
  explicit Workspace(const BooleanOptions& o) : options(o) {}

  const BooleanOptions& options;
  Geometry geometry;
  std::unique_ptr<Kernel> kernel;
  PerOperand<Patch> patch;

  // While the reduction is at work; then it hands them over as Contacts.
  std::vector<Contact> contacts;   ///< ascending by entities, crossings last
  Table<PlaceId, PointId> places;  ///< the point of each place
  std::vector<SegmentRecord> records;

  const Kernel& tests() const { return *kernel; }
  PointId point(PlaceId place) const { return places[place]; }

  /// Throws Cancelled if that was asked for. Loops that take long call it now and then.
  void check_cancelled() const {
    if (options.cancel && options.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
};

}  // namespace sectile
