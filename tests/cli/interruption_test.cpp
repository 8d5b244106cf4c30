// Ctrl-C during long work.
#include <signal.h>

#include <chrono>
#include <thread>

#include "mesh_files.h"
#include "program.h"

namespace sectile::test {
namespace {

class Interruption : public ProgramTest {
 protected:
  Ended interrupted_after(std::chrono::milliseconds delay, int signal) const {
    return run({"union", "a.off", "b.off", "-o", "c.off"}, "", [&](int process) {
      std::this_thread::sleep_for(delay);
      kill(process, signal);
    });
  }
};

TEST_F(Interruption, LeavesNoOutput) {
  write("a.off", content(bulged_cube(120, 0.5), Format::off));
  write("b.off", content(bulged_cube(120, 0.5000001), Format::off));
  write("c.off", "old");
  const std::set<std::string> before = files();
  // Early on the signal ends the program as it ends any other, later it cancels the operation, and
  // at last it finds nothing more to end. Each delay must leave all or nothing.
  bool cancelled = false, finished = false;
  for (int delay = 20; delay < 60000 && !finished; delay = delay * 5 / 4) {
    const Ended ended = interrupted_after(std::chrono::milliseconds(delay), SIGINT);
    finished = ended.code == 0;
    EXPECT_EQ(files(), before) << "after " << delay << " ms";
    if (finished) {
      EXPECT_NE(read("c.off"), "old");
      break;
    }
    EXPECT_EQ(ended.signal, SIGINT) << "after " << delay << " ms: " << ended.err;
    EXPECT_EQ(read("c.off"), "old");
    if (ended.err.find("interrupted; nothing was written") != std::string::npos) cancelled = true;
  }
  EXPECT_TRUE(cancelled) << "no delay hit the operation";
  EXPECT_TRUE(finished);
}

}  // namespace
}  // namespace sectile::test
