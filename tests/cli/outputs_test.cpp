// Outputs appear whole or not at all; "-" is standard input or output; files that cannot be used.
#include <nlohmann/json.hpp>

#include "mesh_files.h"
#include "program.h"

namespace sectile::test {
namespace {

namespace fs = std::filesystem;

class Outputs : public ProgramTest {
 protected:
  void SetUp() override {
    write("a.obj", content(cube(0, 0, 0), Format::obj));
    write("b.obj", content(cube(1, 1, 1), Format::obj));
  }
  Ended split(const std::string& above, const std::string& below) const {
    return run({"split", "a.obj", "--plane", "0,0,1,-1", "-o", above, below});
  }
  // Code 3, a message with the file's name, and nothing new in the folder.
  void expect_file_failure(const std::vector<std::string>& arguments,
                           const std::string& message) const {
    const std::set<std::string> before = files();
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 3) << ::testing::PrintToString(arguments) << ended.err;
    EXPECT_NE(ended.err.find(message), std::string::npos) << ended.err;
    EXPECT_EQ(ended.out, "");
    EXPECT_EQ(files(), before);
  }
};

TEST_F(Outputs, FilesThatCannotBeRead) {
  expect_file_failure({"union", "a.obj", "missing.obj", "-o", "c.obj"}, "missing.obj: ");
  expect_file_failure({"check", "missing.stl"}, "missing.stl: ");
  expect_file_failure({"check", "."}, ".");
  fs::create_directory(path("folder.obj"));
  expect_file_failure({"union", "a.obj", "folder.obj", "-o", "c.obj"}, "folder.obj: ");
  write("a.dwg", "?");
  expect_file_failure({"check", "a.dwg"}, "a.dwg: unknown extension");
}

TEST_F(Outputs, FilesThatCannotBeWritten) {
  expect_file_failure({"union", "a.obj", "b.obj", "-o", "no/such/c.obj"}, "no/such/c.obj: ");
  expect_file_failure({"union", "a.obj", "b.obj", "-o", "c.dwg"}, "c.dwg: unknown extension");
  fs::create_directory(path("folder.obj"));
  expect_file_failure({"union", "a.obj", "b.obj", "-o", "folder.obj"}, "folder.obj: ");
  expect_file_failure({"trace", "a.obj", "b.obj", "--op", "union", "-o", "no/t.json"}, "no/t.json");
  expect_file_failure({"union", "a.obj", "b.obj", "-o", "/dev/full", "--output-format", "obj"},
                      "/dev/full: ");
}

TEST_F(Outputs, CoordinatesTooLargeForFloatsAreRefused) {
  FileMesh huge = cube(0, 0, 0);
  for (auto& p : huge.positions) p[0] *= 1e39;
  write("huge.obj", content(huge, Format::obj));
  expect_file_failure({"convert", "huge.obj", "-o", "huge.stl"}, "huge.stl: ");
  EXPECT_EQ(run({"convert", "huge.obj", "-o", "huge.off"}).code, 0);
}

TEST_F(Outputs, ASolidOfWhichFloatsHoldNothingIsRefused) {
  write("far.off", content(cube(1e10, 0, 0), Format::off));
  expect_file_failure({"convert", "far.off", "-o", "far.stl"}, "too thin for the numbers");
  EXPECT_EQ(run({"convert", "far.off", "-o", "far.obj"}).code, 0);
}

TEST_F(Outputs, SplitWritesBothOrNone) {
  expect_file_failure({"split", "a.obj", "--plane", "0,0,1,-1", "-o", "c.obj", "no/such/d.obj"},
                      "no/such/d.obj");
  expect_file_failure({"split", "a.obj", "--plane", "0,0,1,-1", "-o", "no/such/c.obj", "d.obj"},
                      "no/such/c.obj");
  expect_file_failure({"split", "a.obj", "--plane", "0,0,1,-1", "-o", "c.obj", "/dev/full",
                       "--output-format", "obj"},
                      "/dev/full");
}

TEST_F(Outputs, ReplacedFilesAreWholeAndLeaveNothingBehind) {
  write("c.obj", "old");
  write("d.obj", "old");
  const std::set<std::string> before = files();
  EXPECT_EQ(split("c.obj", "d.obj").code, 0);
  EXPECT_EQ(files(), before);
  EXPECT_EQ(read("c.obj")[0], 'v');
  EXPECT_EQ(read("d.obj")[0], 'v');
}

TEST_F(Outputs, FailuresLeaveOldFilesAsTheyWere) {
  write("c.obj", "old");
  write("d.obj", "old");
  fs::create_directory(path("e.obj"));
  EXPECT_EQ(split("c.obj", "e.obj").code, 3);
  EXPECT_EQ(read("c.obj"), "old");
  write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  EXPECT_EQ(run({"union", "a.obj", "open.obj", "-o", "d.obj"}).code, 1);
  EXPECT_EQ(read("d.obj"), "old");
}

TEST_F(Outputs, TheOutputMayBeAnInput) {
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "-o", "a.obj"}).code, 0);
  EXPECT_NE(run({"check", "a.obj"}).out.find("volume 15"), std::string::npos);
}

TEST_F(Outputs, LinksLeadToTheFileBehindThem) {
  write("real.obj", "old");
  fs::create_symlink("real.obj", path("link.obj"));
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "-o", "link.obj"}).code, 0);
  EXPECT_TRUE(fs::is_symlink(path("link.obj")));
  EXPECT_EQ(read("real.obj")[0], 'v');
}

TEST_F(Outputs, DevicesAreNotReplaced) {
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "-o", "/dev/null", "--output-format", "off"}).code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST_F(Outputs, StandardInputAndOutput) {
  const Ended ended = run({"union", "-", "b.obj", "-o", "-"}, read("a.obj"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out[0], 'v');
  EXPECT_NE(ended.err.find("volume 15"), std::string::npos) << "the summary must go elsewhere";
  write("piped.obj", ended.out);
  EXPECT_NE(run({"check", "piped.obj"}).out.find("volume 15"), std::string::npos);
}

TEST_F(Outputs, StandardStreamsInEveryFormat) {
  for (const Format format : all_formats) {
    const std::string name = extension_of(format).substr(1);
    const Ended ended =
        run({"convert", "-", "--input-format", name, "-o", "-", "--output-format", name, "--quiet"},
            content(cube(0, 0, 0), format));
    ASSERT_EQ(ended.code, 0) << name << ended.err;
    EXPECT_EQ(ended.err, "");
    write("piped." + name, ended.out);
    EXPECT_NE(run({"check", "piped." + name}).out.find("volume 8"), std::string::npos) << name;
  }
}

TEST_F(Outputs, StandardInputIsNamedInMessages) {
  const Ended ended = run({"check", "-"}, "v 0 0 0\nv 1 0\n");
  EXPECT_EQ(ended.code, 3);
  EXPECT_NE(ended.err.find("standard input:2: "), std::string::npos) << ended.err;
}

TEST_F(Outputs, InputFormatServesUnknownExtensions) {
  write("part.data", content(cube(0, 0, 0), Format::off));
  EXPECT_EQ(run({"union", "part.data", "b.obj", "--input-format", "off", "-o", "c.obj"}).code, 0);
  EXPECT_NE(run({"check", "c.obj"}).out.find("volume 15"), std::string::npos);
}

TEST_F(Outputs, SplitMayUseStandardOutputOnce) {
  const Ended ended = split("-", "below.obj");
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out[0], 'v');
  EXPECT_TRUE(exists("below.obj"));
}

TEST_F(Outputs, FailuresInJson) {
  const auto error_of = [&](const std::vector<std::string>& arguments, int code) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, code);
    EXPECT_NE(ended.err, "");
    const auto json = nlohmann::json::parse(ended.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << ended.out;
    EXPECT_EQ(json.value("exit_code", -1), code);
    return json["error"];
  };
  write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const auto open = error_of({"union", "a.obj", "open.obj", "-o", "c.obj", "--json"}, 1);
  EXPECT_EQ(open["file"], "open.obj");
  EXPECT_EQ(open["problems"][0]["reason"], "open");
  EXPECT_EQ(open["problems"][0]["face"], 0);
  EXPECT_EQ(error_of({"union", "a.obj", "no.obj", "-o", "c.obj", "--json"}, 3)["kind"], "file");
  EXPECT_EQ(error_of({"split", "a.obj", "--plane", "0,0,0,0", "-o", "c.obj", "d.obj", "--json"},
                     2)["kind"],
            "wrong_usage");
}

}  // namespace
}  // namespace sectile::test
