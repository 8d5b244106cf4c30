// The loops of parallel.h for ThreadSanitizer. oneTBB is not compiled with it: what its tasks, and
// its memory, take from one thread to another looks like races. These run on threads that are seen.
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "parallel/parallel.h"

namespace sectile::parallel {
namespace {

constexpr std::size_t most_parts = 32;

// How many more threads may be started, so that loops within loops do not start hundreds.
std::atomic<int> spare_threads{3};

class Helpers {
 public:
  explicit Helpers(std::size_t wanted) {
    while (count_ < wanted && spare_threads.fetch_sub(1, std::memory_order_relaxed) > 0) ++count_;
    if (count_ < wanted) spare_threads.fetch_add(1, std::memory_order_relaxed);
  }
  ~Helpers() { spare_threads.fetch_add(static_cast<int>(count_), std::memory_order_relaxed); }
  Helpers(const Helpers&) = delete;
  Helpers& operator=(const Helpers&) = delete;
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

// Calls body(i) for all i below `count`.
void run(std::size_t count, Work<std::size_t> body) {
  std::atomic<std::size_t> next{0};
  std::mutex mutex;
  std::exception_ptr thrown;
  const auto work = [&] {
    for (std::size_t i; (i = next.fetch_add(1, std::memory_order_relaxed)) < count;) try {
        body(i);
      } catch (...) {
        next = count;
        const std::lock_guard lock(mutex);
        thrown = std::current_exception();
      }
  };
  const Helpers helpers(count - 1);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < helpers.count(); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (thrown) std::rethrow_exception(thrown);
}

}  // namespace

void run_parts(std::size_t first, std::size_t last, std::size_t grain,
               Work<std::size_t, std::size_t> work) {
  const std::size_t size = last - first,
                    count = std::clamp<std::size_t>(size / grain, 1, most_parts);
  const auto start = [&](std::size_t i) {
    return first + size / count * i + std::min(i, size % count);
  };
  run(count, Work<std::size_t>([&](std::size_t i) { work(start(i), start(i + 1)); }));
}

void run_isolated(Work<> work) {
  work();
}

}  // namespace sectile::parallel
