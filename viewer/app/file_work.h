// Files are read and written away from the interface's thread.
#pragma once

#include <functional>
#include <future>
#include <string>
#include <vector>

namespace sectile::viewer {

class FileWork {
 public:
  /// What is to be done with the outcome, in the interface's thread.
  using Finish = std::function<void()>;
  enum class Kind { reading, writing };

  /// `work` runs in a thread of its own and must not throw. `activity` tells people what it does.
  void start(Kind kind, std::string activity, std::function<Finish()> work);
  /// Calls what the finished works have left to do. `wait`: until all are finished.
  void finish(bool wait);
  /// What is being read is not wanted any more. What is being written will be whole.
  void give_up_reading();
  bool is_busy() const;
  std::string activity() const;  ///< of the first work that runs; empty: none does

 private:
  struct Work {
    Kind kind;
    std::string activity;
    std::future<Finish> outcome;
    bool wanted = true;
  };
  std::vector<Work> running_;
};

}  // namespace sectile::viewer
