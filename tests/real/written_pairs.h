// Booleans of randomly placed meshes, written and looked at by a checker that knows nothing of the
// library.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "sectile/sectile.h"

namespace sectile::test {

class WrittenPairs {
 public:
  explicit WrittenPairs(unsigned seed) : random_(seed) {}

  /// A mesh, moved into the cube [-1, 1]³; false if it is no solid then.
  bool add(const std::string& file);

  /// Union, intersection and difference of so many pairs, in doubles and in floats.
  void run(int count);

  std::size_t meshes() const { return solids_.size(); }
  int written() const { return written_; }
  int illegal() const { return illegal_; }
  /// Those that moves as large as reported do not explain.
  int other_shape() const { return other_shape_; }
  int refused() const { return refused_; }
  /// Over all corners that moved, in units in the last place of 1.
  double median(Rounding::Numbers numbers) const;
  std::string summary() const;

 private:
  double number(double low, double high);
  void one_pair();
  void write(const Solid& solid, Rounding::Numbers numbers, const std::string& name);

  std::mt19937 random_;
  std::vector<Solid> solids_;
  std::vector<std::string> names_;
  int pairs_ = 0, written_ = 0, illegal_ = 0, other_shape_ = 0, refused_ = 0, resolved_ = 0,
      displaced_ = 0;
  double boolean_ = 0, rounding_ = 0, largest_[2] = {0, 0};
  std::vector<double> medians_[2];  // per mesh written in doubles, in floats
};

}  // namespace sectile::test
