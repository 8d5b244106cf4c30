#include "search/face_slab.h"

#include "numbers/rounding.h"
#include "search/approximate.h"

namespace sectile {

using namespace approximate;

FaceSlab::FaceSlab(std::span<const Vec3> corners) {
  const Vec3 origin = corners.front();
  Vec3 last = corners[1] - origin;
  for (const Vec3& p : corners.subspan(2)) {
    const Vec3 at = p - origin;
    normal_ = normal_ + cross(last, at);
    last = at;
  }
  low_ = high_ = dot(normal_, origin);
  double reach = 0;
  for (const Vec3& p : corners) {
    const double at = dot(normal_, p);
    low_ = std::min(low_, at);
    high_ = std::max(high_, at);
    reach = std::max(reach, max_norm(p));
  }
  weight_ = 16 * rounding::unit * sum_norm(normal_);
  error_ = weight_ * reach + 0x1p-900 * (1 + sum_norm(normal_));
}

// Any direction would do: what counts is only how well the products are known. Fewer than eight
// roundings for each, and one of each coordinate. What is not finite is not apart.
bool apart(const FaceSlab& slab, const Box& box) {
  const double n[3] = {slab.normal_.x, slab.normal_.y, slab.normal_.z};
  double middle = 0, half = 0, reach = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = static_cast<double>(box.low[k]), high = static_cast<double>(box.high[k]);
    middle += n[k] * (0.5 * (low + high));
    half += std::abs(n[k]) * (0.5 * (high - low));
    reach = std::max(reach, std::max(std::abs(low), std::abs(high)));
  }
  const double error = slab.error_ + 2 * slab.weight_ * reach;
  return middle - half - error > slab.high_ || middle + half + error < slab.low_;
}

}  // namespace sectile
