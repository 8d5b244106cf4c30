// Parallel loops that are always run to their end, or throw.
//
// A loop of TBB within a task whose group is cancelled, because another task of it has thrown,
// returns at once, without a word and with half of its work undone. Whoever calls the library from
// a parallel loop of his own, in which anything may throw, must not get half a solid by that. So
// these loops are groups of their own: only what is thrown in them ends them early.
//
// Bodies are called through a pointer, once for each part of a loop: what runs the parts is
// compiled in one place, and not once more for each loop.
#pragma once

#include <cstddef>
#include <memory>
#include <mutex>

#include "parallel/alone.h"
#include "parallel/range.h"

namespace sectile::parallel {

/// Work that is there as long as the call to which it is given takes.
template <class... Arguments>
class Work {
 public:
  template <class Body>
  explicit Work(const Body& body)
      : body_(std::addressof(body)), call_([](const void* of, Arguments... arguments) {
          (*static_cast<const Body*>(of))(arguments...);
        }) {}
  void operator()(Arguments... arguments) const { call_(body_, arguments...); }

 private:
  const void* body_;
  void (*call_)(const void*, Arguments...);
};

/// Calls work(begin, end) for parts of what is from `first` up to, but without, `last`.
void run_parts(std::size_t first, std::size_t last, std::size_t grain,
               Work<std::size_t, std::size_t> work);
void run_isolated(Work<> work);

/// Calls body(part) for parts of a range.
template <class Number, class Body>
void loop(const Range<Number>& range, const Body& body) {
  if (range.empty()) return;
  if (Alone::now()) return body(range);
  run_parts(range.begin(), range.end(), range.grain(),
            Work<std::size_t, std::size_t>([&](std::size_t begin, std::size_t end) {
              body(Range<Number>(static_cast<Number>(begin), static_cast<Number>(end)));
            }));
}

/// Calls body(i) for all i from `first` up to, but without, `last`.
template <class Body>
void loop(std::size_t first, std::size_t last, const Body& body) {
  loop(Range<std::size_t>(first, last), [&](const Range<std::size_t>& part) {
    for (std::size_t i = part.begin(); i < part.end(); ++i) body(i);
  });
}

/// Joins body(part, start) of parts of a range, in any order.
template <class Number, class Value, class Body, class Join>
Value reduce(const Range<Number>& range, const Value& start, const Body& body, const Join& join) {
  Value joined = start;
  std::mutex mutex;
  loop(range, [&](const Range<Number>& part) {
    const Value of_part = body(part, start);
    const std::lock_guard lock(mutex);
    joined = join(joined, of_part);
  });
  return joined;
}

/// Runs two pieces of work beside each other.
template <class First, class Second>
void invoke(const First& first, const Second& second) {
  loop(0, 2, [&](std::size_t i) { i == 0 ? first() : second(); });
}

/// Runs body(); who waits in it for parts of a loop takes no tasks of loops around it meanwhile.
/// What is found out once in this way may be large, however small the work is that asks for it.
template <class Body>
void isolate(const Body& body) {
  const Alone with_others(false);
  run_isolated(Work<>(body));
}

}  // namespace sectile::parallel
