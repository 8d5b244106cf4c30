// Exit code 4: defects of the library, and memory that runs out.
#include <gtest/gtest.h>

#include "failures.h"
#include "mesh_files.h"
#include "program.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

void fail() {
  throw InternalError("a defect");
}

struct Told {
  cli::ExitCode code;
  std::string out, err;
};

Told told(bool json) {
  cli::Options options;
  options.json = json;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const cli::ExitCode code = cli::run_and_tell(
      "union",
      [&] {
        fail();
        return cli::ExitCode::done;
      },
      options);
  return {code, ::testing::internal::GetCapturedStdout(), ::testing::internal::GetCapturedStderr()};
}

TEST(InternalFailure, IsADefect) {
  const Told plain = told(false), json = told(true);
  EXPECT_EQ(plain.code, cli::ExitCode::internal_failure);
  EXPECT_EQ(static_cast<int>(plain.code), 4);
  EXPECT_EQ(plain.out, "");
  EXPECT_EQ(plain.err, "sectile: a defect\n");
  EXPECT_EQ(json.code, cli::ExitCode::internal_failure);
  EXPECT_EQ(json.out,
            "{\"command\":\"union\",\"exit_code\":4,"
            "\"error\":{\"kind\":\"internal\",\"message\":\"a defect\"}}\n");
}

class OutOfMemory : public ProgramTest {
 protected:
  void SetUp() override {
#ifdef SECTILE_SANITIZE
    GTEST_SKIP() << "AddressSanitizer needs terabytes of addresses, so they cannot be limited.";
#endif
    write("a.obj", content(bulged_cube(50, 0.3), Format::obj));
    write("b.obj", content(cube(0.1, 0.1, 0.1), Format::obj));
    write("c.out", "old");
  }

  // With more and more memory the command fails again and again, each time a little later, and
  // leaves no trace; with enough it does its work.
  void expect_all_or_nothing(const std::vector<std::string>& arguments) {
    const std::set<std::string> before = files();
    std::set<std::string> messages;
    int failures = 0;
    for (std::size_t bytes = 24 << 20; bytes < std::size_t{4} << 30; bytes += bytes / 16) {
      limit_memory(bytes);
      const Ended ended = run(arguments);
      EXPECT_EQ(files(), before);
      if (ended.code == 0) break;
      ++failures;
      ASSERT_EQ(ended.code, 4) << bytes << ", signal " << ended.signal << ": " << ended.err;
      EXPECT_EQ(ended.err, "sectile: out of memory\n") << bytes;
      EXPECT_EQ(ended.out, "");
      EXPECT_EQ(read("c.out"), "old");
    }
    EXPECT_GE(failures, 3);
    EXPECT_NE(read("c.out"), "old") << "it never had enough";
  }
};

// Of one thread: the system's refusal to start another has its own message.
TEST_F(OutOfMemory, LeavesNothingBehind) {
  expect_all_or_nothing({"subtract", "a.obj", "b.obj", "-o", "c.out", "--output-format", "obj",
                         "--threads", "1", "--quiet"});
}

TEST_F(OutOfMemory, LeavesNoTraceBehind) {
  expect_all_or_nothing(
      {"trace", "a.obj", "b.obj", "--op", "union", "-o", "c.out", "--threads", "1", "--quiet"});
}

TEST_F(OutOfMemory, OfManyThreadsIsFoundToo) {
  const std::set<std::string> before = files();
  int failures = 0;
  for (std::size_t bytes = 96 << 20; bytes < std::size_t{4} << 30; bytes += bytes / 8) {
    limit_memory(bytes);
    const Ended ended = run({"union", "a.obj", "b.obj", "-o", "c.out", "--output-format", "stl",
                             "--threads", "8", "--quiet"});
    EXPECT_EQ(files(), before);
    if (ended.code == 0) break;
    ++failures;
    ASSERT_EQ(ended.code, 4) << bytes << ", signal " << ended.signal << ": " << ended.err;
    EXPECT_EQ(read("c.out"), "old");
  }
  EXPECT_NE(read("c.out"), "old") << "it never had enough";
}

}  // namespace
}  // namespace sectile::test
