// Equal ones among many elements, found by their hashes.
//
// The elements are dealt out into parts by their hashes first. A part is so small that its table
// stays in fast memory, and one thread has it alone; a table of all would be waited for at each
// step.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "numbers/threshold.h"
#include "numbers/unset_vector.h"
#include "parallel/parallel.h"
#include "parallel/scratch.h"

namespace sectile {

template <class HashOf, class Equal, class Meet>
class EqualElements {
 public:
  EqualElements(std::size_t count, const HashOf& hash_of, const Equal& equal, const Meet& meet)
      : hash_of_(hash_of), equal_(equal), meet_(meet), elements_(count) {}

  void run() {
    if (elements_.size() < 2 * size_of_part) {
      for (std::uint32_t i = 0; i < elements_.size(); ++i) elements_[i] = {hash_of_(i), i};
      std::vector<std::uint32_t> table;
      look_at(elements_, table);
    } else {
      deal_out();
      parallel::Scratch<std::vector<std::uint32_t>> tables;
      parallel::loop(0, end_of_part_.size(), [&](std::size_t part) {
        const std::size_t begin = part > 0 ? end_of_part_[part - 1] : 0;
        tables.lend([&](auto& table) {
          look_at(std::span(elements_).subspan(begin, end_of_part_[part] - begin), table);
        });
      });
    }
  }

 private:
  struct Element {
    std::uint32_t hash, number;
  };
  static constexpr std::size_t size_of_part = threshold(1024, 4), most_parts = 2048;
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  // By the highest bits of the hashes. Each slice of the elements is counted, and then moved.
  void deal_out() {
    const std::size_t count = elements_.size();
    const std::size_t parts = std::min(std::bit_ceil(count / size_of_part), most_parts);
    const int shift = 32 - std::countr_zero(parts);
    const std::size_t slices = std::clamp<std::size_t>(count >> 15, 1, 16);
    UnsetVector<std::uint32_t> hashes(count);
    std::vector<std::vector<std::uint32_t>> at(slices, std::vector<std::uint32_t>(parts));
    const auto for_each = [&](std::size_t slice, const auto& visit) {
      const std::size_t end = count * (slice + 1) / slices;
      for (std::size_t i = count * slice / slices; i < end; ++i)
        visit(static_cast<std::uint32_t>(i));
    };
    parallel::loop(0, slices, [&](std::size_t s) {
      for_each(s, [&](std::uint32_t i) { ++at[s][(hashes[i] = hash_of_(i)) >> shift]; });
    });
    end_of_part_.resize(parts);
    std::uint32_t end = 0;
    for (std::size_t part = 0; part < parts; ++part) {
      for (auto& of_slice : at) end += std::exchange(of_slice[part], end);
      end_of_part_[part] = end;
    }
    parallel::loop(0, slices, [&](std::size_t s) {
      for_each(s, [&](std::uint32_t i) {
        elements_[at[s][hashes[i] >> shift]++] = {hashes[i], i};
      });
    });
  }

  // Open addressing by the lowest bits. Ascending numbers: the first of equal ones comes first.
  void look_at(std::span<const Element> part, std::vector<std::uint32_t>& table) const {
    table.assign(std::bit_ceil(2 * part.size() + 1), none);
    const std::size_t mask = table.size() - 1;
    for (std::uint32_t i = 0; i < part.size(); ++i) {
      std::size_t at = part[i].hash & mask;
      while (table[at] != none && !same(part[table[at]], part[i])) at = (at + 1) & mask;
      if (table[at] == none)
        table[at] = i;
      else
        meet_(part[table[at]].number, part[i].number);
    }
  }
  bool same(const Element& a, const Element& b) const {
    return a.hash == b.hash && equal_(a.number, b.number);
  }

  const HashOf& hash_of_;
  const Equal& equal_;
  const Meet& meet_;
  UnsetVector<Element> elements_;  // ascending in each part
  std::vector<std::uint32_t> end_of_part_;
};

/// Calls meet(first, i) for each of the elements 0 … count - 1 that equals an earlier one; the
/// first of those is `first`. Among equal ones i ascends; others are met beside, by other threads.
/// `hash_of` has all 32 bits well mixed.
template <class HashOf, class Equal, class Meet>
void for_each_equal(std::size_t count, const HashOf& hash_of, const Equal& equal,
                    const Meet& meet) {
  EqualElements(count, hash_of, equal, meet).run();
}

}  // namespace sectile
