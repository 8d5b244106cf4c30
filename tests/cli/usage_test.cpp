// Help, the version, and command lines that make no sense.
#include "mesh_files.h"
#include "program.h"

namespace sectile::test {
namespace {

class Usage : public ProgramTest {
 protected:
  void SetUp() override {
    write("a.obj", content(cube(0, 0, 0), Format::obj));
    write("b.obj", content(cube(1, 1, 1), Format::obj));
  }
  void expect_refused(const std::vector<std::string>& arguments, const std::string& why) const {
    const std::set<std::string> before = files();
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 2) << ::testing::PrintToString(arguments) << ended.err;
    EXPECT_NE(ended.err.find(why), std::string::npos)
        << ::testing::PrintToString(arguments) << ": " << ended.err;
    EXPECT_EQ(files(), before);
  }
};

TEST_F(Usage, VersionAndHelp) {
  const Ended version = run({"--version"});
  EXPECT_EQ(version.code, 0);
  EXPECT_EQ(version.out.substr(0, 8), "sectile ");
  const Ended help = run({"--help"});
  EXPECT_EQ(help.code, 0);
  for (const char* word : {"Examples:", "union", "intersect", "subtract", "split", "check", "info",
                           "convert", "trace", "Exit codes:"})
    EXPECT_NE(help.out.find(word), std::string::npos) << word;
}

TEST_F(Usage, EveryOptionHasHelp) {
  for (const char* command :
       {"union", "intersect", "subtract", "split", "check", "info", "convert", "trace"}) {
    const Ended help = run({command, "--help"});
    EXPECT_EQ(help.code, 0);
    for (const char* option : {"--json", "--quiet", "--threads", "--input-format"}) {
      const std::size_t at = help.out.find(option);
      ASSERT_NE(at, std::string::npos) << command << " " << option;
      // Words follow, on this line or indented on the next.
      const std::string after = help.out.substr(at, 240);
      EXPECT_NE(after.find("  "), std::string::npos) << command << " " << option;
    }
  }
}

TEST_F(Usage, MissingParts) {
  expect_refused({}, "subcommand is required");
  expect_refused({"frobnicate"}, "");
  expect_refused({"union"}, "required");
  expect_refused({"union", "a.obj", "-o", "c.obj"}, "");
  expect_refused({"union", "a.obj", "b.obj"}, "--output");
  expect_refused({"split", "a.obj", "-o", "c.obj", "d.obj"}, "--plane");
  expect_refused({"split", "a.obj", "--plane", "0,0,1,0", "-o", "c.obj"}, "--output");
  expect_refused({"trace", "a.obj", "b.obj", "-o", "t.json"}, "--op");
}

TEST_F(Usage, WrongValues) {
  expect_refused({"union", "a.obj", "b.obj", "-o", "c.obj", "--frob"}, "--frob");
  expect_refused({"union", "a.obj", "b.obj", "-o", "c.obj", "--threads", "0"}, "--threads");
  expect_refused({"union", "a.obj", "b.obj", "-o", "c.obj", "--threads", "many"}, "--threads");
  expect_refused({"union", "a.obj", "b.obj", "-o", "c.obj", "--output-format", "dwg"}, "dwg");
  expect_refused({"trace", "a.obj", "b.obj", "--op", "xor", "-o", "t.json"}, "xor");
}

TEST_F(Usage, PlanesThatAreNone) {
  for (const char* plane : {"0,0,0,1", "0,0,1", "0,0,1,2,3", "0,0,1,nan", "0,0,inf,1", "a,b,c,d",
                            "", "0,0,1,", "0 0 1 0", "1e999,0,0,0"})
    expect_refused({"split", "a.obj", "--plane", plane, "-o", "c.obj", "d.obj"}, "plane");
}

TEST_F(Usage, NamesThatMakeNoSenseTogether) {
  expect_refused({"split", "a.obj", "--plane", "0,0,1,-1", "-o", "c.obj", "./c.obj"}, "same name");
  expect_refused({"split", "a.obj", "--plane", "0,0,1,-1", "-o", "-", "-"}, "same name");
  expect_refused({"union", "-", "-", "-o", "c.obj"}, "only once");
  expect_refused({"union", "a.obj", "b.obj", "-o", "-", "--json"}, "standard output");
}

}  // namespace
}  // namespace sectile::test
