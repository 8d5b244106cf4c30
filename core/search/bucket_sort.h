// Sorting what belongs to numbered things, such as the edges of a solid: linear where few belong to
// each.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "numbers/threshold.h"
#include "numbers/unset_vector.h"
#include "parallel/parallel.h"

namespace sectile {

template <class Vector, class Bucket, class Less>
class BucketSort {
 public:
  BucketSort(Vector& elements, std::size_t buckets, const Bucket& bucket, const Less& less)
      : elements_(elements), buckets_(buckets), bucket_(bucket), less_(less), begin_(buckets + 1) {}

  std::vector<std::uint32_t> run() {
    dealt_.resize(elements_.size());
    if (elements_.size() < parallel_from) {
      std::copy(elements_.begin(), elements_.end(), dealt_.begin());
      sort_group(0, buckets_, 0, dealt_.size());
    } else {
      deal_out();
      parallel::loop(0, end_of_group_.size(), [&](std::size_t g) {
        sort_group(g << shift_, std::min(buckets_, (g + 1) << shift_),
                   g > 0 ? end_of_group_[g - 1] : 0, end_of_group_[g]);
      });
    }
    begin_.back() = static_cast<std::uint32_t>(elements_.size());
    return std::move(begin_);
  }

 private:
  using T = typename Vector::value_type;
  static constexpr std::size_t parallel_from = threshold(8192, 8),
                               size_of_slice = threshold(8192, 4), most_groups = 512;

  // Into groups of neighbouring buckets. Each slice of the elements is counted, and then moved.
  void deal_out() {
    while (buckets_ >> shift_ >= most_groups) ++shift_;
    const std::size_t count = elements_.size(), groups = (buckets_ >> shift_) + 1,
                      slices = std::clamp<std::size_t>(count / size_of_slice, 1, 64);
    std::vector<std::vector<std::uint32_t>> at(slices, std::vector<std::uint32_t>(groups));
    const auto for_each = [&](std::size_t slice, const auto& visit) {
      const std::size_t end = count * (slice + 1) / slices;
      for (std::size_t i = count * slice / slices; i < end; ++i)
        visit(elements_[i], at[slice][bucket_(elements_[i]) >> shift_]);
    };
    parallel::loop(0, slices, [&](std::size_t s) {
      for_each(s, [](const T&, std::uint32_t& in_group) { ++in_group; });
    });
    std::uint32_t end = 0;
    for (std::size_t g = 0; g < groups; ++g) {
      for (auto& of_slice : at) end += std::exchange(of_slice[g], end);
      end_of_group_.push_back(end);
    }
    parallel::loop(0, slices, [&](std::size_t s) {
      for_each(s, [&](const T& e, std::uint32_t& place) { dealt_[place++] = e; });
    });
  }

  // Back into the elements, of which these buckets have those from `from` up to, but without, `to`.
  void sort_group(std::size_t first, std::size_t last, std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) ++begin_[bucket_(dealt_[i])];
    auto end = static_cast<std::uint32_t>(from);
    for (std::size_t b = first; b < last; ++b) end += std::exchange(begin_[b], end);
    // Filling a bucket moves its begin to its end.
    for (std::size_t i = from; i < to; ++i) elements_[begin_[bucket_(dealt_[i])]++] = dealt_[i];
    for (std::size_t b = last; b-- > first;) {
      const std::uint32_t begin = b > first ? begin_[b - 1] : static_cast<std::uint32_t>(from);
      const auto sorted = elements_.begin() + begin, sorted_end = elements_.begin() + begin_[b];
      if (sorted_end - sorted > 1) std::sort(sorted, sorted_end, less_);
      begin_[b] = begin;
    }
  }

  Vector& elements_;
  const std::size_t buckets_;
  const Bucket& bucket_;
  const Less& less_;
  std::vector<std::uint32_t> begin_;  // of each bucket
  UnsetVector<T> dealt_;              // group by group
  unsigned shift_ = 0;                // a group has 2^shift buckets
  std::vector<std::uint32_t> end_of_group_;
};

/// Sorts by bucket(element), which is less than `buckets`, and elements of one bucket by `less`,
/// which must leave no two of them equal that can be told apart. Returns where each bucket begins,
/// and the end.
template <class Vector, class Bucket, class Less>
std::vector<std::uint32_t> bucket_sort(Vector& elements, std::size_t buckets, const Bucket& bucket,
                                       const Less& less) {
  return BucketSort(elements, buckets, bucket, less).run();
}

}  // namespace sectile
