#include "parallel/alone.h"

#include <utility>

namespace sectile::parallel {
namespace {

thread_local bool is_alone = false;

}  // namespace

Alone::Alone(bool alone) : before_(std::exchange(is_alone, alone)) {}
Alone::~Alone() {
  is_alone = before_;
}
bool Alone::now() {
  return is_alone;
}

}  // namespace sectile::parallel
