#include "program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace sectile::test {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void put(const fs::path& path, const std::string& content) {
  std::ofstream out(path, std::ios::binary);
  out << content;
  if (!out.flush()) throw std::runtime_error("cannot write " + path.string());
}

// In the child process: only calls that are safe after fork.
[[noreturn]] void become_program(const char* work, const char* const streams[3],
                                 char* const* arguments, std::size_t most_memory) {
  for (int stream = 0; stream < 3; ++stream) {
    const int file = open(streams[stream], stream == 0 ? O_RDONLY : O_WRONLY | O_CREAT | O_TRUNC,
                          S_IRUSR | S_IWUSR);
    if (file < 0 || dup2(file, stream) < 0) _exit(126);
  }
  const rlimit limit{most_memory, most_memory};
  if (most_memory > 0 && setrlimit(RLIMIT_AS, &limit) != 0) _exit(126);
  if (chdir(work) == 0) execv(arguments[0], arguments);
  _exit(127);
}

}  // namespace

ProgramTest::ProgramTest() {
  std::string name = (fs::temp_directory_path() / "sectile-test-XXXXXX").string();
  if (!mkdtemp(name.data())) throw std::runtime_error("cannot make a folder");
  folder_ = name;
  work_ = folder_ / "work";
  fs::create_directory(work_);
}

ProgramTest::~ProgramTest() {
  std::error_code ignored;
  fs::permissions(work_, fs::perms::owner_all, ignored);
  fs::remove_all(folder_, ignored);
}

Ended ProgramTest::run(const std::vector<std::string>& arguments, const std::string& input) const {
  return run(arguments, input, [](int) {});
}

Ended ProgramTest::run(const std::vector<std::string>& arguments, const std::string& input,
                       const std::function<void(int)>& meanwhile) const {
  const std::string in = folder_ / "in", out = folder_ / "out", err = folder_ / "err";
  put(in, input);
  const char* const streams[3] = {in.c_str(), out.c_str(), err.c_str()};
  std::vector<std::string> words{SECTILE_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);

  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot fork");
  if (child == 0) become_program(work_.c_str(), streams, pointers.data(), most_memory_);
  meanwhile(child);
  int status = 0;
  if (waitpid(child, &status, 0) != child) throw std::runtime_error("cannot wait");

  Ended ended;
  if (WIFEXITED(status)) ended.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) ended.signal = WTERMSIG(status);
  ended.out = content_of(out);
  ended.err = content_of(err);
  return ended;
}

void ProgramTest::write(const std::string& name, const std::string& content) const {
  put(work_ / name, content);
}

std::string ProgramTest::read(const std::string& name) const {
  return content_of(work_ / name);
}

bool ProgramTest::exists(const std::string& name) const {
  return fs::exists(work_ / name);
}

std::set<std::string> ProgramTest::files() const {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(work_))
    names.insert(entry.path().filename().string());
  return names;
}

}  // namespace sectile::test
