// Every defect in every format: the documented exit code, a message that names the file and the
// place, no output, and nothing else left in the folder.
#include <limits>
#include <regex>

#include "mesh_files.h"
#include "program.h"

namespace sectile::test {
namespace {

class MalformedFiles : public ProgramTest, public ::testing::WithParamInterface<Format> {
 protected:
  void SetUp() override { write("good.obj", content(cube(1, 1, 1), Format::obj)); }

  std::string file() const { return "bad" + extension_of(GetParam()); }
  bool is_stl() const { return GetParam() == Format::stl || GetParam() == Format::stl_binary; }
  std::string good_content() const { return content(cube(0, 0, 0), GetParam()); }

  // A file with a defect that its reader finds: its line, or its byte in binary files.
  void expect_unreadable(const std::string& bad) const {
    expect_refused(bad, 3, file() + ":( byte)? ?[0-9]+: ", {});
  }
  void expect_illegal(const FileMesh& bad, const std::string& message,
                      const std::vector<std::string>& options = {}) const {
    expect_refused(content(bad, GetParam()), 1, file() + ": not a legal solid: .*" + message,
                   options);
  }

 private:
  void expect_refused(const std::string& bad, int code, const std::string& message,
                      const std::vector<std::string>& options) const {
    write(file(), bad);
    const std::set<std::string> before = files();
    for (std::vector<std::string> arguments :
         {std::vector<std::string>{"check", file()},
          {"union", "good.obj", file(), "-o", "c.obj"},
          {"subtract", file(), "good.obj", "-o", "c.off"},
          {"split", file(), "--plane", "0,0,1,-1", "-o", "c.obj", "d.obj"},
          {"convert", file(), "-o", "c.ply"},
          {"trace", "good.obj", file(), "--op", "union", "-o", "t.json"}}) {
      if (arguments[0] != "check")
        arguments.insert(arguments.end(), options.begin(), options.end());
      const Ended ended = run(arguments);
      EXPECT_EQ(ended.code, code) << arguments[0] << ": " << ended.err;
      EXPECT_TRUE(std::regex_search(ended.err, std::regex(message)))
          << arguments[0] << ": " << ended.err;
      EXPECT_EQ(ended.out, "") << arguments[0];
      EXPECT_EQ(files(), before) << arguments[0];
    }
  }
};

TEST_P(MalformedFiles, TheGoodOneIsGood) {
  write(file(), good_content());
  const Ended ended = run({"check", file()});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("volume 8"), std::string::npos);
}

TEST_P(MalformedFiles, Empty) {
  expect_unreadable("");
}

TEST_P(MalformedFiles, Truncated) {
  const std::string good = good_content();
  // Within a position: in OBJ the first line, elsewhere wherever half of the file is.
  expect_unreadable(GetParam() == Format::obj ? good.substr(0, 4)
                                              : good.substr(0, good.size() / 2));
}

TEST_P(MalformedFiles, TruncatedAfterALine) {
  std::string text = good_content();
  if (GetParam() == Format::obj) {
    FileMesh cut = cube(0, 0, 0);
    cut.faces.pop_back();
    expect_illegal(cut, "open");  // OBJ does not say how much there should be
    return;
  }
  text.pop_back();
  text = text.substr(0, text.rfind('\n') + 1);
  expect_unreadable(text);
}

TEST_P(MalformedFiles, IndexOutOfRange) {
  if (is_stl()) GTEST_SKIP() << "STL has no indices";
  for (const int index : {8, 1000000, -1}) {
    FileMesh bad = cube(0, 0, 0);
    bad.faces[3][1] = index;
    expect_unreadable(content(bad, GetParam()));
  }
}

TEST_P(MalformedFiles, NotANumber) {
  for (const double value :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    FileMesh bad = cube(0, 0, 0);
    bad.positions[5][1] = value;
    expect_unreadable(content(bad, GetParam()));
  }
}

TEST_P(MalformedFiles, Open) {
  FileMesh bad = cube(0, 0, 0);
  bad.faces.erase(bad.faces.begin() + 2);
  expect_illegal(bad, "open.* face [0-9]+");
}

TEST_P(MalformedFiles, FlippedFace) {
  FileMesh bad = cube(0, 0, 0);
  std::swap(bad.faces[4][1], bad.faces[4][3]);
  expect_illegal(bad, "faces? [0-9]+.* same way");
}

TEST_P(MalformedFiles, InsideOut) {
  FileMesh bad = cube(0, 0, 0);
  for (auto& face : bad.faces) std::swap(face[1], face[3]);
  expect_illegal(bad, "inside out");
}

TEST_P(MalformedFiles, SelfCrossingFace) {
  expect_illegal(self_crossing_prism(), "(face|cross)");
}

TEST_P(MalformedFiles, FacesThatCross) {
  expect_illegal(together(cube(0, 0, 0), cube(0.5, 0.5, 0.5)),
                 "faces? [0-9]+ and [0-9]+ cross.* near \\(");
}

TEST_P(MalformedFiles, Garbage) {
  std::string bad = good_content();
  for (std::size_t i = 0; i < bad.size(); ++i) bad[i] = static_cast<char>(bad[i] ^ (37 + i * 31));
  expect_unreadable(bad);
}

std::string format_name(const ::testing::TestParamInfo<Format>& info) {
  return name_of(info.param);
}
INSTANTIATE_TEST_SUITE_P(Formats, MalformedFiles, ::testing::ValuesIn(all_formats), format_name);

}  // namespace
}  // namespace sectile::test
