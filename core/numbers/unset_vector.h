// Vectors that are not filled with zeros before they are written: for what is large, that is a pass
// over memory, made by one thread, which all others wait for.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace sectile {

template <class T>
class UnsetAllocator : public std::allocator<T> {
 public:
  template <class Other>
  struct rebind {
    using other = UnsetAllocator<Other>;
  };

  UnsetAllocator() = default;
  template <class Other>
  UnsetAllocator(const UnsetAllocator<Other>&) {}

  template <class Element>
  void construct(Element* at) {
    if constexpr (!std::is_trivially_copyable_v<Element>) ::new (static_cast<void*>(at)) Element();
  }
  template <class Element, class... Values>
  void construct(Element* at, Values&&... values) {
    ::new (static_cast<void*>(at)) Element(std::forward<Values>(values)...);
  }
};

/// Of numbers, ids and what consists of these: elements have no value until they get one.
template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace sectile
