#include "app/file_work.h"

#include <algorithm>
#include <utility>

namespace sectile::viewer {

void FileWork::start(Kind kind, std::string activity, std::function<Finish()> work) {
  auto thread = std::make_unique<Background<Task, Finish>>(
      [](const Task& task, WorkState&) { return std::optional<Finish>(task()); });
  thread->request(std::move(work));
  works_.push_back({kind, std::move(activity), std::move(thread), {}, true});
}

void FileWork::finish(bool wait) {
  std::vector<Finish> finished;
  bool earlier_is_read = false;
  std::erase_if(works_, [&](Work& work) {
    if (wait && work.wanted) work.thread->wait();
    if (!work.outcome) work.outcome = work.thread->take();
    if (!work.wanted) return work.outcome.has_value();
    const bool reads = work.kind == Kind::reading;
    if (!work.outcome || (reads && earlier_is_read)) {
      earlier_is_read = earlier_is_read || reads;
      return false;
    }
    finished.push_back(std::move(*work.outcome));
    return true;
  });
  // Only now, as they may start further works.
  for (const Finish& finish : finished) finish();
}

void FileWork::give_up_reading() {
  for (Work& work : works_)
    if (work.kind == Kind::reading) work.wanted = false;
}

bool FileWork::is_busy() const {
  return std::any_of(works_.begin(), works_.end(), [](const Work& w) { return w.wanted; });
}

std::string FileWork::activity() const {
  for (const Work& work : works_)
    if (work.wanted) return work.activity;
  return {};
}

}  // namespace sectile::viewer
