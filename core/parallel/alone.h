// Work so small that it is done before another thread has woken up to take a part of it.
#pragma once

namespace sectile::parallel {

/// While there is one, its thread runs its loops alone, or with others again.
class Alone {
 public:
  explicit Alone(bool alone);
  ~Alone();
  Alone(const Alone&) = delete;
  Alone& operator=(const Alone&) = delete;

  static bool now();

 private:
  bool before_;
};

}  // namespace sectile::parallel
