#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "import/diagnosis.h"
#include "import/soup.h"
#include "rounding/rounded_surface.h"
#include "rounding/rounding_repair.h"
#include "sectile/rounding.h"

namespace sectile {
namespace {

constexpr std::uint32_t none = 0xFFFFFFFFu;
constexpr int most_rounds = 4, most_shells = 1000;

class MeshRounding {
 public:
  MeshRounding(const SolidData& data, const Rounding& options)
      : options_(options), grid_(options), rounded_(data, grid_), kernel_(rounded_.geometry) {}

  RoundedMesh run() {
    if (!rounded_.anything_moved()) {
      make_mesh();
      return std::move(result_);
    }
    faulty_ = faulty_triangles(rounded_, kernel_, control());
    for (int round = 0;; ++round) {
      if (!faulty_.empty()) make_legal();
      make_mesh();
      const std::uint32_t wrong = wrong_shell();
      if (wrong == none) break;
      if (round == most_shells || !repair().turn_shell(wrong)) fail(wrong);
      faulty_ = faulty_triangles(rounded_, kernel_, control());
    }
    note_report();
    return std::move(result_);
  }

 private:
  SelfTestControl control() const { return {options_.cancel, options_.progress}; }

  RoundingRepair& repair() {
    if (!repair_) repair_.emplace(rounded_, kernel_, grid_, options_);
    return *repair_;
  }

  [[noreturn]] void fail(std::uint32_t triangle) const {
    const Vec3& where = rounded_.position(rounded_.corners[triangle][0]);
    throw RoundingFailed("near " + in_words(where) + " the solid is too thin for these numbers",
                         where);
  }

  void make_legal() {
    for (int round = 0; !faulty_.empty(); ++round) {
      if (round == most_rounds) fail(faulty_.front());
      repair().run(std::move(faulty_));
      faulty_ = faulty_triangles(rounded_, kernel_, control());
    }
  }

  void note_report() {
    RoundingReport& report = result_.report;
    report.corners = rounded_.point.size();
    if (repair_) {
      report.merged = repair_->merged();
      report.flipped = repair_->flipped();
    }
    std::vector<double> moves;
    for (std::uint32_t v = 0; v < rounded_.point.size(); ++v) {
      const Vec3& from = rounded_.origin[v];
      const Vec3& to = rounded_.position(repair_ ? repair_->gone_to(v) : v);
      double move = std::hypot(to.x - from.x, to.y - from.y, to.z - from.z);
      if (!(to == grid_.nearest(from))) ++report.displaced;
      // The place itself is off by half a unit in the last place of each coordinate at most.
      if (rounded_.is_exact[v] == 0) {
        const double half = 0x1p-53;
        move += std::hypot(half * from.x, half * from.y, half * from.z);
      }
      if (move == 0) continue;
      moves.push_back(move);
      if (move <= report.largest_move) continue;
      report.largest_move = move;
      report.largest_at = from;
    }
    report.moved = moves.size();
    if (!moves.empty()) {
      const auto middle = moves.begin() + static_cast<std::ptrdiff_t>(moves.size() / 2);
      std::nth_element(moves.begin(), middle, moves.end());
      report.median_move = *middle;
    }
    if (report.largest_move > options_.max_move)
      throw RoundingFailed("the corner at " + in_words(report.largest_at) + " would move by " +
                               std::to_string(report.largest_move) +
                               ", farther than is allowed; allow more, or use finer numbers",
                           report.largest_at);
  }

  void make_mesh() {
    result_.mesh = {};
    result_.sources.clear();
    triangle_.clear();
    std::vector<std::uint32_t> number(rounded_.point.size(), none);
    for (std::uint32_t t = 0; t < rounded_.corners.size(); ++t) {
      if (rounded_.alive[t] == 0) continue;
      for (const std::uint32_t v : rounded_.corners[t]) {
        if (number[v] == none) {
          number[v] = static_cast<std::uint32_t>(result_.mesh.positions.size());
          result_.mesh.positions.push_back(rounded_.position(v));
        }
        result_.mesh.indices.push_back(number[v]);
      }
      result_.mesh.face_sizes.push_back(3);
      result_.sources.push_back(rounded_.source[t]);
      triangle_.push_back(t);
    }
    if (triangle_.empty())
      throw RoundingFailed("nothing is left of the solid in these numbers; use finer ones",
                           rounded_.origin.front());
  }

  // What no two faces show: a shell that was turned inside out, or came to lie in another one. A
  // triangle of it, or none.
  std::uint32_t wrong_shell() const {
    if (is_one_shell() && encloses_volume()) return none;
    try {
      ImportOptions how;
      how.trusted = true;  // the faces were tested
      how.cancel = options_.cancel;
      import_mesh(result_.mesh, how);
      return none;
    } catch (const InvalidSolid& error) {
      return error.face() == no_element ? triangle_.front() : triangle_[error.face()];
    }
  }

  bool is_one_shell() const {
    std::vector<std::uint8_t> seen(rounded_.corners.size(), 0);
    std::vector<std::uint32_t> front{triangle_.front()};
    seen[front.front()] = 1;
    std::size_t count = 1;
    while (!front.empty()) {
      const std::uint32_t t = front.back();
      front.pop_back();
      for (const std::uint32_t mate : rounded_.surface.mate[t]) {
        if (seen[mate] != 0) continue;
        seen[mate] = 1;
        ++count;
        front.push_back(mate);
      }
    }
    return count == triangle_.size();
  }

  // Certainly: far more than the rounding errors of the sum.
  bool encloses_volume() const {
    const Vec3 o = rounded_.position(rounded_.corners[triangle_.front()][0]);
    double sum = 0, size = 0, reach = 1;
    for (const std::uint32_t t : triangle_) {
      double p[3][3];
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& v = rounded_.position(rounded_.corners[t][k]);
        p[k][0] = v.x - o.x;
        p[k][1] = v.y - o.y;
        p[k][2] = v.z - o.z;
        for (const double along : p[k]) reach = std::max(reach, std::abs(along));
      }
      for (int k = 0; k < 3; ++k) {
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        const double left = p[0][k] * p[1][i] * p[2][j], right = p[0][k] * p[1][j] * p[2][i];
        sum += left - right;
        size += std::abs(left) + std::abs(right);
      }
    }
    // Products that underflow are off by the least double times a third factor.
    return sum > 0x1p-20 * size && size > 0x1p-900 * reach && triangle_.size() < 0x1p28;
  }

  const Rounding& options_;
  RoundingGrid grid_;
  RoundedSurface rounded_;
  Kernel kernel_;
  std::optional<RoundingRepair> repair_;
  std::vector<std::uint32_t> faulty_;
  std::vector<std::uint32_t> triangle_;  // per face of the mesh
  RoundedMesh result_;
};

}  // namespace

RoundedMesh rounded_mesh(const Solid& solid, const Rounding& rounding) {
  if (solid.is_empty()) return {};
  return MeshRounding(*solid.data(), rounding).run();
}

}  // namespace sectile
