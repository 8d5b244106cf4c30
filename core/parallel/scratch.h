// Memory that the bodies of a loop work in, or collect in: whoever needs one takes one that nobody
// uses and gives it back. Unlike memory of a thread, a body never finds that of another one that
// waits, half done, on the same thread.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace sectile::parallel {

template <class T>
class Scratch {
 public:
  explicit Scratch(std::function<T()> make = [] { return T(); }) : make_(std::move(make)) {}

  /// Calls use(one that is used by no other). If that throws, this one is lost.
  template <class Use>
  void lend(const Use& use) {
    std::unique_ptr<T> one = take();
    use(*one);
    const std::lock_guard lock(mutex_);
    free_.push_back(std::move(one));
  }

  /// Calls visit(each), in any order, when none is lent any more.
  template <class Visit>
  void for_each(const Visit& visit) const {
    for (const std::unique_ptr<T>& one : free_) visit(std::as_const(*one));
  }

 private:
  std::unique_ptr<T> take() {
    {
      const std::lock_guard lock(mutex_);
      if (!free_.empty()) {
        std::unique_ptr<T> one = std::move(free_.back());
        free_.pop_back();
        return one;
      }
    }
    return std::unique_ptr<T>(new T(make_()));
  }

  std::function<T()> make_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<T>> free_;
};

}  // namespace sectile::parallel
