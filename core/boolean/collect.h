// Runs a loop on all cores and collects what it produces, in the order of the loop.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "boolean/workspace.h"
#include "parallel/parallel.h"

namespace sectile {

/// Calls body(first, last, output) for ranges of at most `size` of the numbers 0 … count - 1;
/// `output` is one Output for each. begin() is called before each; what it throws ends the loop.
template <class Output, class Body, class Begin>
std::vector<Output> collect_ranges(std::size_t count, std::size_t size, const Body& body,
                                   const Begin& begin) {
  const std::size_t ranges = (count + size - 1) / size;
  std::vector<Output> outputs(ranges);
  const auto run = [&](std::size_t r) {
    begin();
    body(r * size, std::min(count, (r + 1) * size), outputs[r]);
  };
  if (ranges <= 1) {
    if (ranges == 1) run(0);
  } else {
    parallel::loop(0, ranges, run);
  }
  return outputs;
}

/// The same; throws Cancelled before the next range if that was asked for.
template <class Output, class Body>
std::vector<Output> collect_ranges(const Workspace& w, std::size_t count, std::size_t size,
                                   const Body& body) {
  return collect_ranges<Output>(count, size, body, [&] { w.check_cancelled(); });
}

/// Calls body(i, output) for i = 0 … count - 1; `output` is one Output for each range of `size`.
template <class Output, class Body>
std::vector<Output> collect(std::size_t count, std::size_t size, const Body& body) {
  const auto each = [&](std::size_t first, std::size_t last, Output& output) {
    for (std::size_t i = first; i < last; ++i) body(i, output);
  };
  return collect_ranges<Output>(count, size, each, [] {});
}
template <class Output, class Body>
std::vector<Output> collect(const Workspace& w, std::size_t count, std::size_t size,
                            const Body& body) {
  return collect_ranges<Output>(w, count, size,
                                [&](std::size_t first, std::size_t last, Output& output) {
                                  for (std::size_t i = first; i < last; ++i) body(i, output);
                                });
}

/// Without an output.
template <class Body>
void for_each_range(const Workspace& w, std::size_t count, std::size_t size, const Body& body) {
  struct Nothing {};
  collect_ranges<Nothing>(
      w, count, size, [&](std::size_t first, std::size_t last, Nothing&) { body(first, last); });
}
template <class Body>
void for_each(const Workspace& w, std::size_t count, std::size_t size, const Body& body) {
  for_each_range(w, count, size, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) body(i);
  });
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}
/// The first of several is not copied: where little is to be done, there are no others.
template <class T>
void append(std::vector<T>& to, std::vector<T>&& from) {
  if (to.empty())
    to = std::move(from);
  else
    append(to, std::as_const(from));
}

/// What was collected, in one.
template <class T>
std::vector<T> joined(std::vector<std::vector<T>> parts) {
  if (parts.size() == 1) return std::move(parts[0]);
  std::size_t size = 0;
  for (const std::vector<T>& part : parts) size += part.size();
  std::vector<T> all;
  all.reserve(size);
  for (const std::vector<T>& part : parts) append(all, part);
  return all;
}

}  // namespace sectile
