// Runs a loop on all cores and collects what it produces, in the order of the loop.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "boolean/workspace.h"
#include "numbers/threshold.h"
#include "numbers/unset_vector.h"
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

template <class Vector>
void append(Vector& to, const std::type_identity_t<Vector>& from) {
  to.insert(to.end(), from.begin(), from.end());
}
/// The first of several is not copied: where little is to be done, there are no others.
template <class Vector>
void append(Vector& to, std::type_identity_t<Vector>&& from) {
  if (to.empty())
    to = std::move(from);
  else
    append(to, std::as_const(from));
}

/// Where of(part) of each part begins, when all stand one after the other; and the end.
template <class Part, class Of>
std::vector<std::uint32_t> begins_of(const std::vector<Part>& parts, const Of& of) {
  std::vector<std::uint32_t> begin = {0};
  begin.reserve(parts.size() + 1);
  for (const Part& part : parts)
    begin.push_back(begin.back() + static_cast<std::uint32_t>(of(part).size()));
  return begin;
}

/// What was collected, in one. The vectors are those of(part).
template <class Vector, class Part, class Of>
Vector joined(std::vector<Part>& parts, const Of& of) {
  if (parts.empty()) return {};
  if (parts.size() == 1) return std::move(of(parts[0]));
  const std::vector<std::uint32_t> begin = begins_of(parts, of);
  Vector all;
  if constexpr (std::is_same_v<Vector, UnsetVector<typename Vector::value_type>>) {
    all.resize(begin.back());
    constexpr std::size_t few = threshold(64, 2);
    parallel::loop(parallel::Range<std::size_t>(0, parts.size(), few), [&](const auto& some) {
      for (std::size_t i = some.begin(); i < some.end(); ++i)
        std::ranges::copy(of(parts[i]), all.begin() + begin[i]);
    });
  } else {
    all.reserve(begin.back());
    for (Part& part : parts) append(all, of(part));
  }
  return all;
}
template <class Vector>
Vector joined(std::vector<Vector> parts) {
  return joined<Vector>(
      parts, [](auto& part) -> auto& { return part; });
}

}  // namespace sectile
