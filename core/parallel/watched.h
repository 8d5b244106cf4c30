// The loops of parallel.h for ThreadSanitizer. oneTBB is not compiled with it: what its tasks, and
// its memory, take from one thread to another looks like races. These run on threads that are seen.
#pragma once

#include <tbb/blocked_range.h>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace sectile::parallel {
namespace watched {

// How many more threads may be started, so that loops within loops do not start hundreds.
inline std::atomic<int> spare_threads{3};

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

template <class Body>
void run(std::size_t count, const Body& body) {
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
  const Helpers helpers(std::max<std::size_t>(count, 1) - 1);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < helpers.count(); ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (thrown) std::rethrow_exception(thrown);
}

template <class Range>
std::vector<Range> parts_of(const Range& whole) {
  std::vector<Range> parts{whole};
  for (int halvings = 0; halvings < 5; ++halvings)
    for (std::size_t i = parts.size(); i-- > 0;)
      if (parts[i].is_divisible()) {
        Range half(parts[i], tbb::split());
        parts.push_back(half);
      }
  return parts;
}

}  // namespace watched

template <class Range, class Body>
void loop(const Range& range, const Body& body) {
  if (range.empty()) return;
  const std::vector<Range> parts = watched::parts_of(range);
  watched::run(parts.size(), [&](std::size_t i) { body(parts[i]); });
}

template <class Body>
void loop(std::size_t first, std::size_t last, const Body& body) {
  if (first < last) watched::run(last - first, [&](std::size_t i) { body(first + i); });
}

template <class Range, class Value, class Body, class Join>
Value reduce(const Range& range, const Value& start, const Body& body, const Join& join) {
  if (range.empty()) return start;
  const std::vector<Range> parts = watched::parts_of(range);
  struct Slot {
    Value value;
  };
  std::vector<Slot> values(parts.size(), Slot{start});
  watched::run(parts.size(), [&](std::size_t i) { values[i].value = body(parts[i], start); });
  Value joined = start;
  for (const Slot& slot : values) joined = join(joined, slot.value);
  return joined;
}

template <class First, class Second>
void invoke(const First& first, const Second& second) {
  watched::run(2, [&](std::size_t i) { i == 0 ? first() : second(); });
}

template <class Body>
void isolate(const Body& body) {
  body();
}

template <class Iterator, class Less = std::less<>>
void sort(Iterator begin, Iterator end, const Less& less = Less()) {
  std::sort(begin, end, less);
}

}  // namespace sectile::parallel
