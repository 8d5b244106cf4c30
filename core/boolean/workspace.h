// What one operation works on: the loaded parts of both operands, one geometry, and the records of
// the phases.
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
  bool of_complement = false;  ///< wedges are those of the result's complement
  Geometry geometry;
  std::unique_ptr<Kernel> kernel;
  PerOperand<Patch> patch;

  // Reduction.
  std::vector<Contact> contacts;   ///< ascending by entities, crossings last
  Table<PlaceId, PointId> places;  ///< the point of each place
  std::vector<SegmentRecord> records;

  // Neighborhoods: what lies around each segment, and the wedges of each wanted result.
  std::vector<Segment> segments;
  std::vector<Carrier> carriers;
  std::vector<HalfPlane> half_planes;
  std::vector<std::vector<WedgePair>> wedges;  ///< per wanted operation

  // Null edges.
  std::vector<Site> sites;
  std::vector<CutEnd> cut_ends;
  std::vector<std::pair<std::uint8_t, EdgeId>> null_edges;

  /// The loaded faces in which null edges link corners that touch each other.
  std::vector<std::pair<std::uint8_t, FaceId>> bridged;

  const Kernel& tests() const { return *kernel; }
  PointId point(PlaceId place) const { return places[place]; }

  /// Throws Cancelled if that was asked for. Loops that take long call it now and then.
  void check_cancelled() const {
    if (options.cancel && options.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
};

}  // namespace sectile
