// A table of shared objects, each once: frames, directions.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "numbers/threshold.h"

namespace sectile {

template <class Value>
class SharedTable {
 public:
  using Pointer = std::shared_ptr<const Value>;

  /// The place of an object, where it is put if it is new.
  std::uint32_t place(const Pointer& value) {
    if (last_ < items_.size() && items_[last_] == value) return last_;
    return last_ = items_.size() < few ? among_few(value) : among_many(value);
  }

  std::size_t size() const { return items_.size(); }
  const Pointer& operator[](std::uint32_t place) const { return items_[place]; }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }

 private:
  // Most solids have no more: so many are looked at one by one.
  static constexpr std::size_t few = threshold(16, 1);

  std::uint32_t among_few(const Pointer& value) {
    const auto at = std::find(items_.begin(), items_.end(), value);
    const auto place = static_cast<std::uint32_t>(at - items_.begin());
    if (at == items_.end()) items_.push_back(value);
    return place;
  }
  std::uint32_t among_many(const Pointer& value) {
    if (places_.empty())
      for (const Pointer& item : items_) note(item);
    const auto [at, is_new] = note(value);
    if (is_new) items_.push_back(value);
    return at->second;
  }
  auto note(const Pointer& value) {
    return places_.emplace(value.get(), static_cast<std::uint32_t>(places_.size()));
  }

  std::vector<Pointer> items_;
  std::unordered_map<const Value*, std::uint32_t> places_;  // empty as long as there are few
  std::uint32_t last_ = 0;  // as a rule, the next point has the frame of this one
};

}  // namespace sectile
