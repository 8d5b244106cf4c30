#include "limited_run.h"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <system_error>
#include <type_traits>

namespace sectile::bench {
namespace {

static_assert(std::is_trivially_copyable_v<Measured>);

[[noreturn]] void work_and_write(int pipe_end, unsigned seconds,
                                 const std::function<Measured()>& work) {
  alarm(seconds);
  try {
    const Measured measured = work();
    _exit(write(pipe_end, &measured, sizeof measured) == sizeof measured ? 0 : 1);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    _exit(1);
  }
}

}  // namespace

std::optional<Measured> limited_run(unsigned seconds, const std::function<Measured()>& work) {
  int ends[2];
  if (pipe(ends) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  const pid_t child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
  if (child == 0) {
    close(ends[0]);
    work_and_write(ends[1], seconds, work);
  }
  close(ends[1]);
  Measured measured;
  const bool complete = read(ends[0], &measured, sizeof measured) == sizeof measured;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (complete) return measured;
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM) return std::nullopt;
  throw std::runtime_error("the measured process failed");
}

}  // namespace sectile::bench
