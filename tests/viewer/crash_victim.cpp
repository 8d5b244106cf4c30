// A modeller that works at random until it is killed. Tells what its scene is after each event:
// "seconds index" lines into a log, so that a second run of the same seed, which is not killed,
// says what the scene was.
//   crash_victim DATA_FOLDER LOG SEED EVENTS
#include <fcntl.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "scene/scene_file.h"
#include "viewer/random_person.h"

namespace {

using namespace sectile::viewer;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Not buffered: what was written stays when the process is killed.
void tell(int log, const std::string& line) {
  if (write(log, line.data(), line.size()) != static_cast<ssize_t>(line.size())) std::abort();
}

int run(char** arguments) {
  const int log = open(arguments[2], O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (log < 0) return 3;
  // Who tells scenes is there for these alone.
  const bool tells_scenes = std::getenv("SECTILE_TELL_SCENES");
  AppOptions options = tells_scenes ? AppDriver::waiting() : AppDriver::drawing();
  options.data_folder = arguments[1];
  AppDriver driver(options, 800, 520);
  driver.key(Key::escape);
  RandomPerson person(driver, std::strtoull(arguments[3], nullptr, 10));
  // Something that can be lost.
  driver.add("block");
  const int events = std::atoi(arguments[4]);
  for (int i = 0; i < events; ++i) {
    char line[64];
    std::snprintf(line, sizeof line, "%d %.6f\n", i, now());
    tell(log, line);
    if (tells_scenes) {
      const Document& document = driver.session().document;
      const std::string text = document.is_changed() ? scene_text({document.committed(), {}}) : "";
      tell(log, std::to_string(text.size()) + "\n" + text + "\n");
    }
    person.act();
  }
  // What is waited for is the kill.
  for (;;) driver.settle(1);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 5) return 2;
  try {
    return run(arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "crash_victim: %s\n", error.what());
    return 4;
  }
}
