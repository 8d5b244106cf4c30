#include "growth/steps.h"

#include <tbb/global_control.h>

#include <cstdlib>
#include <new>
#include <stdexcept>

namespace {

constinit thread_local std::uint64_t steps = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  steps += size / 64;
  void* const memory =
      alignment <= alignof(std::max_align_t)
          ? std::malloc(size > 0 ? size : 1)
          : std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

// The compiler calls this in each basic block (-fsanitize-coverage=trace-pc).
extern "C" void __sanitizer_cov_trace_pc();
extern "C" void __sanitizer_cov_trace_pc() {
  ++steps;
}

void* operator new(std::size_t size) {
  return allocate(size, 1);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace sectile {

std::uint64_t steps_of(const std::function<void()>& work) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const std::uint64_t before = steps;
  work();
  const std::uint64_t taken = steps - before;
  if (taken == 0) throw std::logic_error("nothing was counted: core is not compiled to count");
  return taken;
}

}  // namespace sectile
