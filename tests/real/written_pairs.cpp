#include "real/written_pairs.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "unit/exact_mesh_checker.h"
#include "unit/same_shape.h"

namespace sectile::test {
namespace {

using Numbers = Rounding::Numbers;
using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Moved into the cube [-1, 1]³.
PolygonMesh normalised(PolygonMesh mesh) {
  Vec3 low = mesh.positions.at(0), high = low;
  for (const Vec3& p : mesh.positions) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double size = std::max({high.x - low.x, high.y - low.y, high.z - low.z}) / 2;
  for (Vec3& p : mesh.positions)
    p = {(p.x - (low.x + high.x) / 2) / size, (p.y - (low.y + high.y) / 2) / size,
         (p.z - (low.z + high.z) / 2) / size};
  return mesh;
}

}  // namespace

bool WrittenPairs::add(const std::string& file) {
  try {
    const PolygonMesh mesh = read_mesh(file);
    if (mesh.positions.empty()) return false;
    const Solid solid = Solid::from_mesh(normalised(mesh));
    if (solid.is_empty()) return false;
    solids_.push_back(solid);
  } catch (const Error&) {
    return false;
  }
  names_.push_back(file.substr(file.rfind('/') + 1));
  return true;
}

void WrittenPairs::run(int count) {
  for (int i = 0; i < count; ++i) one_pair();
  pairs_ += count;
}

double WrittenPairs::median(Numbers numbers) const {
  std::vector<double> all = medians_[numbers == Numbers::floats];
  if (all.empty()) return 0;
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

std::string WrittenPairs::summary() const {
  char text[600];
  std::snprintf(
      text, sizeof text,
      "%zu meshes, %d pairs, %d meshes written: %d illegal, %d of another shape, %d refused, %d "
      "resolved on a "
      "coarser grid, %d corners not at the nearest place; Booleans %.0f ms, rounding %.0f "
      "ms; in doubles the median of the meshes' median moves is %.3g, the largest move "
      "%.3g units in the last place of 1, in floats %.3g and %.3g",
      meshes(), pairs_, written_, illegal_, other_shape_, refused_, resolved_, displaced_, boolean_,
      rounding_, median(Numbers::doubles), largest_[0], median(Numbers::floats), largest_[1]);
  return text;
}

double WrittenPairs::number(double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random_);
}

void WrittenPairs::one_pair() {
  const auto pick = [&] { return random_() % solids_.size(); };
  const std::size_t i = pick(), j = pick();
  const Transform place =
      Transform::translation({number(-0.6, 0.6), number(-0.6, 0.6), number(-0.6, 0.6)}) *
      Transform::rotation_degrees({number(-1, 1), number(-1, 1), number(0.1, 1)}, number(0, 360));
  const Solid other = transformed(solids_[j], place);
  for (const Operation operation : {Operation::unite, Operation::intersect, Operation::subtract}) {
    const auto start = Clock::now();
    const Solid result = boolean(solids_[i], other, operation);
    boolean_ += milliseconds_since(start);
    for (const Numbers numbers : {Numbers::doubles, Numbers::floats})
      write(result, numbers, names_[i] + " " + std::to_string(int(operation)) + " " + names_[j]);
  }
}

void WrittenPairs::write(const Solid& solid, Numbers numbers, const std::string& name) {
  Rounding rounding;
  rounding.numbers = numbers;
  const auto start = Clock::now();
  RoundedMesh rounded;
  try {
    rounded = rounded_mesh(solid, rounding);
  } catch (const RoundingFailed& error) {
    std::printf("REFUSED %s: %s\n", name.c_str(), error.what());
    ++refused_;
    return;
  }
  const double time = milliseconds_since(start);
  rounding_ += time;
  ++written_;
  const double unit = numbers == Numbers::floats ? 0x1p-23 : 0x1p-52;
  const std::size_t which = numbers == Numbers::floats;
  largest_[which] = std::max(largest_[which], rounded.report.largest_move / unit);
  if (rounded.report.moved > 0) medians_[which].push_back(rounded.report.median_move / unit);
  displaced_ += static_cast<int>(rounded.report.displaced);
  if (rounded.report.resolved > 0) ++resolved_;
  if (rounded.report.resolved > 0 || time > 2000)
    std::printf("%s numbers %d: resolved %zu, largest move %.3g units, %.0f ms, %zu triangles\n",
                name.c_str(), int(numbers), rounded.report.resolved,
                rounded.report.largest_move / unit, time, rounded.mesh.face_sizes.size());
  if (const std::string fault = ExactMeshChecker(rounded.mesh).verdict(); !fault.empty()) {
    std::printf("ILLEGAL %s numbers %d: %s\n", name.c_str(), int(numbers), fault.c_str());
    ++illegal_;
  }
  if (const std::string fault = shape_fault(solid, rounded); !fault.empty()) {
    std::printf("ANOTHER SHAPE %s numbers %d: %s\n", name.c_str(), int(numbers), fault.c_str());
    ++other_shape_;
  }
  std::fflush(stdout);
}

}  // namespace sectile::test
