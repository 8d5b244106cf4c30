// Parallel loops that are always run to their end, or throw.
//
// A loop of TBB within a task whose group is cancelled, because another task of it has thrown,
// returns at once, without a word and with half of its work undone. Whoever calls the library from
// a parallel loop of his own, in which anything may throw, must not get half a solid by that. So
// these loops are groups of their own: only what is thrown in them ends them early.
#pragma once

#ifdef __SANITIZE_THREAD__
#include "parallel/watched.h"
#else

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <cstddef>
#include <functional>

namespace sectile::parallel {

/// Calls body(range) for parts of a range.
template <class Range, class Body>
void loop(const Range& range, const Body& body) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(range, body, own);
}

/// Calls body(i) for all i from `first` up to, but without, `last`.
template <class Body>
void loop(std::size_t first, std::size_t last, const Body& body) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::parallel_for(first, last, body, own);
}

/// Joins body(range, start) of parts of a range, in any order.
template <class Range, class Value, class Body, class Join>
Value reduce(const Range& range, const Value& start, const Body& body, const Join& join) {
  tbb::task_group_context own(tbb::task_group_context::isolated);
  return tbb::parallel_reduce(range, start, body, join, own);
}

/// Runs two pieces of work beside each other.
template <class First, class Second>
void invoke(const First& first, const Second& second) {
  loop(0, 2, [&](std::size_t i) { i == 0 ? first() : second(); });
}

/// Runs body(); who waits in it for parts of a loop takes no tasks of loops around it meanwhile.
template <class Body>
void isolate(const Body& body) {
  tbb::this_task_arena::isolate(body);
}

template <class Iterator, class Less = std::less<>>
void sort(Iterator begin, Iterator end, const Less& less = Less()) {
  constexpr std::ptrdiff_t few = 500;  // as for TBB, which sorts these on one core
  if (end - begin < few) return std::sort(begin, end, less);
  tbb::task_group_context own(tbb::task_group_context::isolated);
  tbb::task_group(own).run_and_wait([&] { tbb::parallel_sort(begin, end, less); });
}

}  // namespace sectile::parallel

#endif
