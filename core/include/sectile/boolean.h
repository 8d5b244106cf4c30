// Boolean operations, splitting by a plane, and the classification of boundaries.
#pragma once

#include <atomic>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "sectile/solid.h"

namespace sectile {

class Observer;  // sectile/trace.h

enum class Operation { unite, intersect, subtract };

/// The points p with a·p.x + b·p.y + c·p.z + d >= 0 (paper, eqs. 1 to 3). (a, b, c) is not zero.
struct HalfSpace {
  double a = 0, b = 0, c = 1, d = 0;
};

/// How an operation is to be run.
struct BooleanOptions {
  bool validate = false;                      ///< check all invariants after every phase
  Observer* observer = nullptr;               ///< told about every phase; not owned
  const std::atomic<bool>* cancel = nullptr;  ///< set from outside to stop with Cancelled
  std::function<void(double)> progress;       ///< called now and then with 0 … 1
};

/// The regularised A ∪ B, A ∩ B or A \ B, exactly.
Solid boolean(const Solid& a, const Solid& b, Operation operation);
Solid boolean(const Solid& a, const Solid& b, Operation operation, const BooleanOptions& options);

/// The parts of the solid in the half-space (above) and in its complement (below), both capped.
std::pair<Solid, Solid> split(const Solid& solid, const HalfSpace& half_space);
std::pair<Solid, Solid> split(const Solid& solid, const HalfSpace& half_space,
                              const BooleanOptions& options);

/// The section of a solid by the plane that bounds the half-space: closed loops, material on the
/// left as seen against the plane's normal (a, b, c). Coordinates rounded to the nearest doubles.
struct Section {
  std::vector<std::vector<Vec3>> loops;
};
Section section(const Solid& solid, const HalfSpace& half_space);
/// The observer is told of no events.
Section section(const Solid& solid, const HalfSpace& half_space, const BooleanOptions& options);

/// A part of a boundary: polygons with holes, as loops. Not closed in general. The coordinates are
/// rounded to the nearest doubles; the area is that of the exact faces, to two units in the last
/// place.
struct SurfacePart {
  std::vector<Vec3> positions;
  struct Face {
    std::vector<std::vector<std::uint32_t>> loops;  ///< the outer loop first
    FaceSource source;
  };
  std::vector<Face> faces;
  double area = 0;
};

/// The eight-way boundary classification (paper, section 4, figure 12).
struct EightWay {
  SurfacePart a_in_b, a_out_b, a_on_b_plus, a_on_b_minus;
  SurfacePart b_in_a, b_out_a, b_on_a_plus, b_on_a_minus;
};
EightWay classify(const Solid& a, const Solid& b);
/// The observer is told of no events.
EightWay classify(const Solid& a, const Solid& b, const BooleanOptions& options);

/// The four-way classification for an operation (figure 11): the parts on the other boundary are
/// lumped with the others as Table I says (see docs/paper.md for its corrected form).
struct FourWay {
  SurfacePart a_in_b, a_out_b, b_in_a, b_out_a;
};
FourWay classify(const Solid& a, const Solid& b, Operation operation);
FourWay classify(const Solid& a, const Solid& b, Operation operation,
                 const BooleanOptions& options);

}  // namespace sectile
