// The modeller killed at any moment loses at most what was done in the last two seconds.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "scene/recovery.h"

namespace sectile::viewer {
namespace {

namespace fs = std::filesystem;

constexpr double most_lost = 2;  // seconds

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The victim in a process of its own.
class Victim {
 public:
  Victim(const fs::path& data, const fs::path& log, std::uint64_t seed, int events,
         bool tells_scenes) {
    child_ = fork();
    if (child_ != 0) return;
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (tells_scenes) setenv("SECTILE_TELL_SCENES", "1", 1);
    execl(SECTILE_CRASH_VICTIM, SECTILE_CRASH_VICTIM, data.c_str(), log.c_str(),
          std::to_string(seed).c_str(), std::to_string(events).c_str(), nullptr);
    _exit(127);
  }
  ~Victim() { end(); }
  Victim(const Victim&) = delete;
  Victim& operator=(const Victim&) = delete;

  void end() {
    if (child_ <= 0) return;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
    child_ = -1;
  }
  bool is_running() {
    if (child_ > 0 && waitpid(child_, nullptr, WNOHANG) == child_) child_ = -1;
    return child_ > 0;
  }

 private:
  pid_t child_ = -1;
};

/// After how many events it was when, and what the scene was then: nothing if it was not changed.
struct Record {
  double time = 0;
  std::string scene;
};

std::vector<Record> read_log(const fs::path& path, bool with_scenes) {
  std::ifstream in(path, std::ios::binary);
  std::vector<Record> records;
  for (std::size_t index = 0; in >> index;) {
    Record record;
    std::size_t size = 0;
    if (!(in >> record.time)) break;
    if (with_scenes) {
      if (!(in >> size) || in.get() != '\n') break;
      record.scene.resize(size);
      if (!in.read(record.scene.data(), static_cast<std::streamsize>(size))) break;
    }
    if (index != records.size()) throw std::runtime_error("the log skips an event");
    records.push_back(std::move(record));
  }
  return records;
}

class Crash : public testing::TestWithParam<std::uint64_t> {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("sectile_crash_" + std::to_string(getpid()) + "_" + std::to_string(GetParam()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Waits until the log has that many records.
  void wait_for(Victim& victim, std::size_t records, bool with_scenes) {
    for (int i = 0; read_log(folder_ / "log", with_scenes).size() < records; ++i) {
      ASSERT_TRUE(victim.is_running());
      ASSERT_LT(i, 4000);
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
  }

  fs::path folder_;
};

TEST_P(Crash, LosesAtMostTwoSeconds) {
  std::mt19937_64 random(GetParam());
  double killed = 0;
  {
    Victim victim(folder_ / "data", folder_ / "log", GetParam(), 100'000, false);
    wait_for(victim, 3, false);
    std::this_thread::sleep_for(
        std::chrono::milliseconds(std::uniform_int_distribution<int>(100, 9000)(random)));
    ASSERT_TRUE(victim.is_running());
    killed = now();
    victim.end();
  }
  const std::vector<Record> seen = read_log(folder_ / "log", false);
  const std::size_t done = static_cast<std::size_t>(std::count_if(
      seen.begin(), seen.end(), [&](const Record& r) { return r.time <= killed - most_lost; }));
  // What the scene was after each event: told by one that lives.
  Victim witness(folder_ / "witness", folder_ / "log", GetParam(),
                 static_cast<int>(seen.size()) + 2, true);
  wait_for(witness, seen.size() + 2, true);
  const std::vector<Record> told = read_log(folder_ / "log", true);

  const std::vector<LostWork> lost = Recovery::find(folder_ / "data");
  ASSERT_LE(lost.size(), 1u);
  const std::string back = lost.empty() ? std::string() : scene_text(Recovery::read(lost.front()));
  const std::size_t from = done == 0 ? 0 : done - 1;
  const bool known = std::any_of(told.begin() + static_cast<std::ptrdiff_t>(from), told.end(),
                                 [&](const Record& r) { return r.scene == back; });
  EXPECT_TRUE(known || (done == 0 && back.empty()))
      << "killed after " << seen.size() << " events, of which " << done
      << " were done two seconds before; what came back is "
      << (lost.empty() ? "nothing" : "none of the scenes since then");
}

INSTANTIATE_TEST_SUITE_P(Seeds, Crash, testing::Range<std::uint64_t>(1, 9));

}  // namespace
}  // namespace sectile::viewer
