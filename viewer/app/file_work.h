// Files are read and written away from the interface's thread.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "events/background.h"

namespace sectile::viewer {

class FileWork {
 public:
  /// What is to be done with the outcome, in the interface's thread.
  using Finish = std::function<void()>;
  enum class Kind { reading, writing };

  /// `work` runs in a thread of its own and must not throw. `activity` tells people what it does.
  void start(Kind kind, std::string activity, std::function<Finish()> work);
  /// Calls what the finished works have left to do. What is read is handed over in the order in
  /// which it was asked for, whatever is ready first. `wait`: until all are finished.
  void finish(bool wait);
  /// What is being read is not wanted any more. What is being written will be whole.
  void give_up_reading();
  bool is_busy() const;
  std::string activity() const;  ///< of the first work that runs; empty: none does

 private:
  using Task = std::function<Finish()>;
  struct Work {
    Kind kind;
    std::string activity;
    std::unique_ptr<Background<Task, Finish>> thread;
    std::optional<Finish> outcome;
    bool wanted = true;
  };
  std::vector<Work> works_;
};

}  // namespace sectile::viewer
