// A solid's triangles with rounded corners, made legal as far as changes nearby can.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "rounding/displacement.h"
#include "rounding/rounded_surface.h"
#include "rounding/rounding_repair.h"
#include "rounding/rounding_steps.h"

namespace sectile {

class RoundingAttempt {
 public:
  /// `before`: how far the solid's corners are from those of the solid that is to be written.
  RoundingAttempt(const SolidData& data, const RoundingGrid& grid, const Rounding& options,
                  RoundedSurface::Lines lines, const Displacement& before, RoundingSteps& steps);

  /// Of the solid.
  std::size_t corners() const { return rounded_.point.size(); }

  /// False if something is left that no change nearby can mend.
  bool run();
  /// After run() failed: is it for want of room to separate what touches?
  bool is_cramped() const { return is_cramped_; }
  /// Or does something meet where lines were to be apart? These are to be divided, then.
  bool has_lines_that_meet() const { return has_lines_that_meet_; }

  /// After run() succeeded; the report adds to what `result` has already.
  void take(RoundedMesh& result);

  /// After run() failed: the corners near what is left go to a grid of `coarseness` times the
  /// spacing. How far they have come then is put into `moved`.
  std::shared_ptr<const SolidData> coarser(double coarseness, Displacement& moved);

 private:
  RoundingRepair& repair();
  bool separate();
  void check_separated();
  void make_mesh();
  std::uint32_t wrong_shell() const;
  bool is_one_shell() const;
  void note_report(RoundingReport& report) const;
  double move_of(std::uint32_t vertex, const Vec3& to) const;
  std::vector<std::uint8_t> vertices_near_stuck(double distance) const;

  const Rounding& options_;
  const RoundingGrid& grid_;
  const Displacement& before_;
  RoundingSteps& steps_;
  RoundedSurface rounded_;
  Kernel kernel_;
  std::optional<RoundingRepair> repair_;
  std::vector<std::uint32_t> stuck_;  // triangles
  bool shell_is_wrong_ = false;
  bool is_cramped_ = false, has_lines_that_meet_ = false;
  std::size_t separated_ = 0;
  PolygonMesh mesh_;
  std::vector<FaceSource> sources_;
  std::vector<std::uint32_t> triangle_;  // per face of the mesh
};

}  // namespace sectile
