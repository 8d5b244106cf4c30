// Tables: vectors that only ids of their own elements index.
#pragma once

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <utility>

#include "numbers/resize_filled.h"
#include "numbers/unset_vector.h"

namespace sectile {

/// The ids from `first` up to, but without, `last`.
template <class Id>
class IdRange {
 public:
  class Iterator {
   public:
    using value_type = Id;
    using difference_type = std::ptrdiff_t;
    using reference = Id;
    using pointer = const Id*;
    using iterator_category = std::input_iterator_tag;

    constexpr Iterator() = default;
    constexpr explicit Iterator(std::uint32_t at) : at_(at) {}
    constexpr Id operator*() const { return Id(at_); }
    constexpr Iterator& operator++() {
      ++at_;
      return *this;
    }
    constexpr Iterator operator++(int) { return Iterator(at_++); }
    friend constexpr bool operator==(Iterator, Iterator) = default;

   private:
    std::uint32_t at_ = 0;
  };

  constexpr IdRange() = default;
  constexpr IdRange(Id first, Id last) : first_(first.value()), last_(last.value()) {}

  constexpr std::size_t size() const { return last_ - first_; }
  constexpr bool empty() const { return first_ == last_; }
  constexpr Id operator[](std::size_t i) const { return Id(first_ + i); }
  constexpr Id front() const { return Id(first_); }
  constexpr Id back() const { return Id(last_ - 1); }
  constexpr Id end_id() const { return Id(last_); }
  /// How many come before an id of the range.
  constexpr std::size_t index(Id id) const { return id.value() - first_; }
  constexpr bool contains(Id id) const { return first_ <= id.value() && id.value() < last_; }
  /// Takes in end_id().
  constexpr void extend() { ++last_; }
  constexpr Iterator begin() const { return Iterator(first_); }
  constexpr Iterator end() const { return Iterator(last_); }

 private:
  std::uint32_t first_ = 0, last_ = 0;
};

template <class Id, class T>
class Table {
 public:
  using value_type = T;

  Table() = default;
  explicit Table(std::size_t size, const T& value = T()) { assign(size, value); }
  explicit Table(UnsetVector<T> items) : items_(std::move(items)) {}

  T& operator[](Id id) { return items_[id.value()]; }
  const T& operator[](Id id) const { return items_[id.value()]; }
  std::span<T> operator[](IdRange<Id> ids) {
    return std::span(items_).subspan(ids.front().value(), ids.size());
  }
  std::span<const T> operator[](IdRange<Id> ids) const {
    return std::span(items_).subspan(ids.front().value(), ids.size());
  }

  bool has(Id id) const { return id.value() < items_.size(); }
  std::size_t size() const { return items_.size(); }
  bool empty() const { return items_.empty(); }
  /// The id that the next new element gets.
  Id end_id() const { return Id(items_.size()); }
  IdRange<Id> ids() const { return {Id(0), end_id()}; }
  /// Those from `first` on.
  IdRange<Id> ids_from(Id first) const { return {first, end_id()}; }

  Id add(T item) {
    const Id id = end_id();
    items_.push_back(std::move(item));
    return id;
  }
  void append(const Table& more) {
    items_.insert(items_.end(), more.items_.begin(), more.items_.end());
  }
  T& back() { return items_.back(); }
  const T& back() const { return items_.back(); }
  void reserve(std::size_t size) { items_.reserve(size); }
  void resize(std::size_t size) {
    if constexpr (std::is_trivially_copyable_v<T>)
      resize_filled(items_, size, T());
    else
      items_.resize(size);
  }
  void resize(std::size_t size, const T& value) { resize_filled(items_, size, value); }
  /// New elements are to be written before anything else is done with them.
  void resize_unwritten(std::size_t size) { items_.resize(size); }
  void assign(std::size_t size, const T& value) {
    items_.clear();
    resize(size, value);
  }
  void clear() { items_.clear(); }

  auto begin() { return items_.begin(); }
  auto end() { return items_.end(); }
  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  /// The elements without their ids.
  UnsetVector<T>& items() { return items_; }
  const UnsetVector<T>& items() const { return items_; }

  friend bool operator==(const Table&, const Table&) = default;

 private:
  UnsetVector<T> items_;
};

}  // namespace sectile
