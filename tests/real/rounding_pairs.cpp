// Writes results of Booleans of randomly placed meshes and looks at them with a checker that knows
// nothing of the library: rounding_pairs COUNT SEED FILE...
#include <chrono>
#include <cstdio>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "sectile/sectile.h"
#include "unit/exact_mesh_checker.h"

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

class Pairs {
 public:
  explicit Pairs(unsigned seed) : random_(seed) {}

  void add(const std::string& file) {
    try {
      solids_.push_back(Solid::from_mesh(normalised(read_mesh(file))));
      names_.push_back(file.substr(file.rfind('/') + 1));
    } catch (const Error&) {
      // Not a legal solid once it is moved: nothing for this program.
    }
  }

  int run(int count) {
    std::printf("%zu meshes\n", solids_.size());
    for (int i = 0; i < count; ++i) one_pair();
    std::printf(
        "%d pairs, %d meshes written, %d illegal, %d refused, %d resolved on a coarser grid; "
        "Booleans %.0f ms, rounding %.0f ms; largest move %.3g and median %.3g of a unit in the "
        "last place of 1\n",
        count, written_, illegal_, refused_, resolved_, boolean_, rounding_, largest_, median_);
    return illegal_ + refused_ > 0;
  }

 private:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }

  void one_pair() {
    const auto pick = [&] { return random_() % solids_.size(); };
    const std::size_t i = pick(), j = pick();
    const Transform place =
        Transform::translation({number(-0.6, 0.6), number(-0.6, 0.6), number(-0.6, 0.6)}) *
        Transform::rotation_degrees({number(-1, 1), number(-1, 1), number(0.1, 1)}, number(0, 360));
    const Solid other = transformed(solids_[j], place);
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract}) {
      const auto start = Clock::now();
      const Solid result = boolean(solids_[i], other, operation);
      boolean_ += milliseconds_since(start);
      for (const Numbers numbers : {Numbers::doubles, Numbers::floats})
        write(result, numbers, names_[i] + " " + std::to_string(int(operation)) + " " + names_[j]);
    }
  }

  void write(const Solid& solid, Numbers numbers, const std::string& name) {
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
    largest_ = std::max(largest_, rounded.report.largest_move / unit);
    median_ = std::max(median_, rounded.report.median_move / unit);
    if (rounded.report.resolved > 0) ++resolved_;
    if (rounded.report.resolved > 0 || time > 2000)
      std::printf("%s numbers %d: resolved %zu, largest move %.3g units, %.0f ms, %zu triangles\n",
                  name.c_str(), int(numbers), rounded.report.resolved,
                  rounded.report.largest_move / unit, time, rounded.mesh.face_sizes.size());
    if (const std::string fault = ExactMeshChecker(rounded.mesh).verdict(); !fault.empty()) {
      std::printf("ILLEGAL %s numbers %d: %s\n", name.c_str(), int(numbers), fault.c_str());
      ++illegal_;
    }
    std::fflush(stdout);
  }

  std::mt19937 random_;
  std::vector<Solid> solids_;
  std::vector<std::string> names_;
  int written_ = 0, illegal_ = 0, refused_ = 0, resolved_ = 0;
  double boolean_ = 0, rounding_ = 0, largest_ = 0, median_ = 0;
};

}  // namespace
}  // namespace sectile::test

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "rounding_pairs COUNT SEED FILE...\n";
    return 2;
  }
  sectile::test::Pairs pairs(static_cast<unsigned>(std::stoul(argv[2])));
  for (int i = 3; i < argc; ++i) pairs.add(argv[i]);
  return pairs.run(std::stoi(argv[1]));
}
