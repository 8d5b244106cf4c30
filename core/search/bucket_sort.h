// Sorting what belongs to numbered things, such as the edges of a solid: linear where few belong to
// each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "numbers/threshold.h"
#include "parallel/parallel.h"

namespace sectile {

/// Sorts by bucket(element), which is less than `buckets`, and elements of one bucket by `less`,
/// which must leave no two of them equal that can be told apart. Returns where each bucket begins,
/// and the end.
template <class T, class Bucket, class Less>
std::vector<std::uint32_t> bucket_sort(std::vector<T>& elements, std::size_t buckets,
                                       const Bucket& bucket, const Less& less) {
  // Counted two places ahead: filling a bucket moves its begin to that of the next one.
  std::vector<std::uint32_t> begin(buckets + 2, 0);
  for (const T& e : elements) ++begin[bucket(e) + 2];
  for (std::size_t b = 2; b < begin.size(); ++b) begin[b] += begin[b - 1];
  std::vector<T> sorted(elements.size());
  for (const T& e : elements) sorted[begin[bucket(e) + 1]++] = e;
  begin.pop_back();
  const auto sort_some = [&](std::size_t first, std::size_t last) {
    for (std::size_t b = first; b < last; ++b)
      if (begin[b + 1] - begin[b] > 1)
        std::sort(sorted.begin() + begin[b], sorted.begin() + begin[b + 1], less);
  };
  constexpr std::size_t chunk = threshold(2048, 8), parallel_from = threshold(8192, 8);
  if (elements.size() < parallel_from)
    sort_some(0, buckets);
  else
    parallel::loop(0, (buckets + chunk - 1) / chunk, [&](std::size_t i) {
      sort_some(i * chunk, std::min(buckets, (i + 1) * chunk));
    });
  elements = std::move(sorted);
  return begin;
}

}  // namespace sectile
