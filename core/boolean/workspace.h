// What all phases of one operation work on: the loaded parts of both operands, and one geometry.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <optional>
#include <vector>

#include "boolean/near/common_faces.h"
#include "boolean/operand.h"
#include "boolean/patch.h"
#include "geometry/kernel.h"
#include "numbers/threshold.h"
#include "parallel/alone.h"
#include "sectile/boolean.h"
#include "sectile/errors.h"

namespace sectile {

struct Workspace {
  explicit Workspace(const BooleanOptions& o) : options(o) {}

  const BooleanOptions& options;
  Geometry geometry;
  std::unique_ptr<Kernel> kernel;
  PerOperand<Patch> patch;
  /// Two points on each line where very many edges run: not all that meets there was looked for
  /// (boolean/near/crowded_lines.h), or it is in no segments (reduction/crowded_segments.h).
  std::vector<std::array<PointId, 2>> crowded_lines;
  /// Points through which very many edges run: faces that meet in nothing else were not tested
  /// (boolean/near/crowded_crossings.h).
  std::vector<PointId> crowded_points;
  /// What of both boundaries is neither loaded nor tested, as it is the same.
  CommonFaces common_faces;
  /// Where little is near, other threads are not woken.
  std::optional<parallel::Alone> alone;

  const Kernel& tests() const { return *kernel; }

  /// `faces` are near, or more: for the phases that follow.
  void stay_alone_with_few(std::size_t faces) {
    constexpr std::size_t few = threshold(2000, 1);
    if (faces <= few) alone.emplace(true);
  }

  /// Throws Cancelled if that was asked for. Loops that take long call it now and then.
  void check_cancelled() const {
    if (options.cancel && options.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
};

}  // namespace sectile
