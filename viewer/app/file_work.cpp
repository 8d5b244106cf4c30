#include "app/file_work.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace sectile::viewer {

void FileWork::start(Kind kind, std::string activity, std::function<Finish()> work) {
  running_.push_back(
      {kind, std::move(activity), std::async(std::launch::async, std::move(work)), true});
}

void FileWork::finish(bool wait) {
  std::vector<Finish> finished;
  std::erase_if(running_, [&](Work& work) {
    const bool awaited = wait && work.wanted;
    if (!awaited && work.outcome.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return false;
    Finish finish = work.outcome.get();
    if (work.wanted) finished.push_back(std::move(finish));
    return true;
  });
  // Only now, as they may start further works.
  for (const Finish& finish : finished) finish();
}

void FileWork::give_up_reading() {
  for (Work& work : running_)
    if (work.kind == Kind::reading) work.wanted = false;
}

bool FileWork::is_busy() const {
  return std::any_of(running_.begin(), running_.end(), [](const Work& w) { return w.wanted; });
}

std::string FileWork::activity() const {
  for (const Work& work : running_)
    if (work.wanted) return work.activity;
  return {};
}

}  // namespace sectile::viewer
