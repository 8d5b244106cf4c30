#include "search/four_faces.h"

#include <bit>
#include <limits>

#include "numbers/rounding.h"
#include "search/approximate.h"

namespace sectile {

using namespace approximate;

FourFaces::FourFaces() {
  const FourFloats none = broadcast(std::numeric_limits<float>::quiet_NaN());
  const Place nowhere{none, none, none};
  normal_ = nowhere;
  low_ = high_ = weight_ = reach_ = none;
  for (Place& corner : corner_) corner = nowhere;
}

// Any direction would do: what counts is only how well the products are known. In floats there are
// one rounding for each coordinate, five for each product, and one for the sum with `low` or
// `high`: less than 32 on both sides together, where these are not so large that no rounding
// matters.
void FourFaces::set(unsigned i, std::span<const Vec3> corners) {
  const Vec3 origin = corners.front();
  Vec3 last = corners[1] - origin, normal{};
  double reach = max_norm(origin);
  for (const Vec3& p : corners.subspan(1)) {
    const Vec3 at = p - origin;
    normal = normal + cross(last, at);
    last = at;
    reach = std::max(reach, max_norm(p));
  }
  normal = (1 / max_norm(normal)) * normal;
  normal_.x[i] = static_cast<float>(normal.x);
  normal_.y[i] = static_cast<float>(normal.y);
  normal_.z[i] = static_cast<float>(normal.z);
  normal = {normal_.x[i], normal_.y[i], normal_.z[i]};
  double low = dot(normal, origin), high = low;
  for (const Vec3& p : corners.subspan(1)) {
    const double at = dot(normal, p);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  constexpr double float_unit = 0x1p-24;
  const double error = 16 * rounding::unit * sum_norm(normal) * reach + 0x1p-900;
  low_[i] = round_down(low - error);
  high_[i] = round_up(high + error);
  weight_[i] = round_up(32 * float_unit * sum_norm(normal));
  reach_[i] = round_up(reach);
  if (corners.size() > std::size(corner_)) {
    most_ = std::size(corner_);
    return;
  }
  most_ = std::max(most_, static_cast<unsigned>(corners.size()));
  for (unsigned k = 0; k < std::size(corner_); ++k) {
    const Vec3& p = corners[std::min<std::size_t>(k, corners.size() - 1)];
    corner_[k].x[i] = static_cast<float>(p.x);
    corner_[k].y[i] = static_cast<float>(p.y);
    corner_[k].z[i] = static_cast<float>(p.z);
  }
}

// Twice as many roundings as of products with corners: of the middle, and of what is around it.
unsigned FourFaces::apart_from(const Box& box) const {
  float middle[3], half[3], reach = 0;
  for (int k = 0; k < 3; ++k) {
    middle[k] = 0.5f * box.low[k] + 0.5f * box.high[k];
    half[k] = 0.5f * box.high[k] - 0.5f * box.low[k];
    reach = std::max(reach, std::max(std::abs(box.low[k]), std::abs(box.high[k])));
  }
  const auto size = [](FourFloats v) {
    return std::bit_cast<FourFloats>(std::bit_cast<FourTruths>(v) & 0x7FFFFFFF);
  };
  const FourFloats at = normal_.x * middle[0] + normal_.y * middle[1] + normal_.z * middle[2];
  const FourFloats around = size(normal_.x) * half[0] + size(normal_.y) * half[1] +
                            size(normal_.z) * half[2] + (2 * reach * weight_ + 0x1p-140f);
  return mask_of((at - around > high_) | (at + around < low_));
}

}  // namespace sectile
