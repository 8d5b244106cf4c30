// What each command does when all is well.
#include <nlohmann/json.hpp>
#include <sstream>

#include "mesh_files.h"
#include "program.h"
#include "sectile/sectile.h"

namespace sectile::test {
namespace {

using Json = nlohmann::json;

class Commands : public ProgramTest {
 protected:
  void SetUp() override {
    write("a.obj", content(cube(0, 0, 0), Format::obj));
    write("b.obj", content(cube(1, 1, 1), Format::obj));
    write("c.obj", content(cube(10, 0, 0), Format::obj));
  }

  // Runs a command that must succeed and print one JSON document and nothing else.
  Json json_of(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err, "");
    const Json json = Json::parse(ended.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << ended.out;
    return json;
  }
  double volume_of(const std::string& file) const {
    return json_of({"check", file}).value("volume", -1.0);
  }
};

TEST_F(Commands, UnionOfTwo) {
  const Ended ended = run({"union", "a.obj", "b.obj", "-o", "u.obj"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out, "u.obj: 20 vertices, 12 faces, 36 triangles, volume 15, area 42, 1 shell\n");
  EXPECT_EQ(ended.err, "");
  EXPECT_EQ(volume_of("u.obj"), 15);
}

TEST_F(Commands, UnionOfAll) {
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "c.obj", "a.obj", "c.obj", "-o", "u.off"}).code, 0);
  const Json json = json_of({"check", "u.off"});
  EXPECT_EQ(json["volume"], 23);
  EXPECT_EQ(json["shells"], 2);
}

// What an operation that failed leaves behind.
TEST_F(Commands, OperandsWithExactNumbers) {
  std::ostringstream half;
  write_exact(half, split(block({0, 0, 0}, {1, 1, 1}), {1, 1, 1, -1}).first);
  write("half.exact", half.str());
  EXPECT_EQ(run({"union", "half.exact", "c.obj", "-o", "u.obj"}).code, 0);
  EXPECT_NEAR(volume_of("u.obj"), 8 + 5.0 / 6, 1e-15);
  write("half.exact", half.str().substr(0, 100));
  const Ended ended = run({"union", "half.exact", "c.obj", "-o", "v.obj"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_TRUE(ended.err.find("half.exact: ") != std::string::npos) << ended.err;
  EXPECT_FALSE(exists("v.obj"));
}

TEST_F(Commands, IntersectionOfAll) {
  EXPECT_EQ(run({"intersect", "a.obj", "b.obj", "a.obj", "-o", "i.ply"}).code, 0);
  EXPECT_EQ(volume_of("i.ply"), 1);
}

TEST_F(Commands, SubtractTakesAllOthersFromTheFirst) {
  write("d.obj", content(cube(-1, -1, -1), Format::obj));
  EXPECT_EQ(run({"subtract", "a.obj", "b.obj", "d.obj", "c.obj", "-o", "s.stl"}).code, 0);
  EXPECT_EQ(volume_of("s.stl"), 6);
}

TEST_F(Commands, EmptyResultIsWrittenAndSaid) {
  for (const char* name : {"e.obj", "e.off", "e.ply", "e.stl"}) {
    const Ended ended = run({"intersect", "a.obj", "c.obj", "-o", name});
    EXPECT_EQ(ended.code, 0);
    EXPECT_NE(ended.err.find("empty"), std::string::npos);
    // It can be read again.
    EXPECT_EQ(json_of({"union", "a.obj", name, "-o", "again.obj"})["outputs"][0]["volume"], 8);
  }
}

TEST_F(Commands, SplitWritesBothParts) {
  const Json json =
      json_of({"split", "a.obj", "--plane", "0,0,1,-1.5", "-o", "up.obj", "down.off"});
  ASSERT_EQ(json["outputs"].size(), 2u);
  EXPECT_EQ(json["outputs"][0]["file"], "up.obj");
  EXPECT_EQ(json["outputs"][0]["volume"], 2);
  EXPECT_EQ(json["outputs"][1]["volume"], 6);
  EXPECT_EQ(volume_of("up.obj"), 2);
  EXPECT_EQ(volume_of("down.off"), 6);
}

TEST_F(Commands, SplitTakesPlanesThatBeginWithAMinus) {
  for (const auto& plane :
       std::vector<std::vector<std::string>>{{"--plane", "-1,0,0,0.5"}, {"--plane=-1,0,0,0.5"}}) {
    std::vector<std::string> arguments{"split", "a.obj", "-o", "above.obj", "below.obj"};
    arguments.insert(arguments.end(), plane.begin(), plane.end());
    EXPECT_EQ(run(arguments).code, 0);
    EXPECT_EQ(volume_of("above.obj"), 2);
    EXPECT_EQ(volume_of("below.obj"), 6);
  }
}

TEST_F(Commands, CheckTellsLegalSolids) {
  const Ended ended = run({"check", "a.obj"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out,
            "a.obj: a legal solid\n"
            "  8 vertices, 12 edges, 6 faces, 6 loops, 1 shell, genus 0\n"
            "  volume 8, area 24\n");
  const Json json = json_of({"check", "a.obj"});
  EXPECT_EQ(json["legal"], true);
  EXPECT_EQ(json["genus"], 0);
  EXPECT_EQ(json["area"], 24);
}

TEST_F(Commands, CheckCountsGenusAndShells) {
  // A frame: a slab without its middle.
  write("slab.obj", content(cube(0, 0, 0), Format::obj));
  FileMesh drill = cube(0.5, 0.5, -1);
  for (auto& p : drill.positions) p = {p[0] > 1 ? 1.5 : 0.5, p[1] > 1 ? 1.5 : 0.5, 3 * p[2]};
  write("drill.obj", content(drill, Format::obj));
  ASSERT_EQ(run({"subtract", "slab.obj", "drill.obj", "-o", "frame.obj"}).code, 0);
  EXPECT_EQ(json_of({"check", "frame.obj"})["genus"], 1);
  write("two.obj", content(together(cube(0, 0, 0), cube(5, 5, 5)), Format::obj));
  EXPECT_EQ(json_of({"check", "two.obj"})["shells"], 2);
}

TEST_F(Commands, InfoDescribesTheFile) {
  const Ended ended = run({"info", "a.obj"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_EQ(ended.out,
            "a.obj: obj\n"
            "  8 positions, 6 faces (0 triangles, 6 quadrilaterals, 0 larger; at most 4 corners)\n"
            "  from (0, 0, 0) to (2, 2, 2)\n"
            "  a solid of 8 vertices, 12 edges, 6 faces, 1 shell, genus 0, volume 8, area 24\n");
  const Json json = json_of({"info", "b.obj"});
  EXPECT_EQ(json["quadrilaterals"], 6);
  EXPECT_EQ(json["box"]["high"], Json::array({3, 3, 3}));
  EXPECT_EQ(json["solid"]["volume"], 8);
}

TEST_F(Commands, InfoDescribesFilesThatBoundNoSolid) {
  FileMesh open = cube(0, 0, 0);
  open.faces.pop_back();
  write("open.off", content(open, Format::off));
  const Ended ended = run({"info", "open.off"});
  EXPECT_EQ(ended.code, 0);
  EXPECT_NE(ended.out.find("not a legal solid"), std::string::npos);
  EXPECT_TRUE(json_of({"info", "open.off"})["solid"].is_null());
}

TEST_F(Commands, ConvertBetweenAllFormats) {
  for (const Format from : all_formats)
    for (const char* to : {"to.obj", "to.off", "to.ply", "to.stl"}) {
      const std::string name = "from_" + name_of(from) + extension_of(from);
      write(name, content(cube(0.25, -3, 1e3), from));
      const Ended ended = run({"convert", name, "-o", to});
      EXPECT_EQ(ended.code, 0) << name << " to " << to << ": " << ended.err;
      const Json json = json_of({"info", to});
      EXPECT_EQ(json["solid"]["volume"], 8) << name << " to " << to;
      EXPECT_EQ(json["triangles"], 12) << name << " to " << to;
    }
}

TEST_F(Commands, ConvertKeepsFacesWhenAsked) {
  EXPECT_EQ(run({"convert", "a.obj", "-o", "a.off", "--keep-faces"}).code, 0);
  EXPECT_EQ(json_of({"info", "a.off"})["quadrilaterals"], 6);
  const Ended ended = run({"convert", "a.obj", "-o", "a.stl", "--keep-faces"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_FALSE(exists("a.stl"));
}

TEST_F(Commands, OutputFormatOverridesTheExtension) {
  EXPECT_EQ(run({"convert", "a.obj", "-o", "a.stl", "--output-format", "stl-text"}).code, 0);
  EXPECT_EQ(read("a.stl").substr(0, 5), "solid");
  EXPECT_EQ(run({"convert", "a.obj", "-o", "a.ply", "--output-format", "ply-binary"}).code, 0);
  EXPECT_NE(read("a.ply").find("binary_little_endian"), std::string::npos);
  EXPECT_EQ(volume_of("a.stl"), 8);
  EXPECT_EQ(volume_of("a.ply"), 8);
}

TEST_F(Commands, TraceWritesEveryPhase) {
  const Ended ended = run({"trace", "a.obj", "b.obj", "--op", "subtract", "-o", "t.json"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  const Json json = Json::parse(read("t.json"), nullptr, false);
  ASSERT_FALSE(json.is_discarded());
  EXPECT_EQ(json["operation"], "subtract");
  EXPECT_EQ(json["volume"], 7);
  std::set<std::string> phases;
  for (const Json& phase : json["phases"]) phases.insert(phase["phase"].get<std::string>());
  EXPECT_EQ(phases,
            (std::set<std::string>{"reduction", "vertex_face", "vertex_vertex", "null_edges",
                                   "joining", "components", "gluing", "cleanup"}));
  EXPECT_EQ(json_of({"trace", "a.obj", "b.obj", "--op", "union", "-o", "t.json"})["command"],
            "trace");
}

TEST_F(Commands, QuietSaysNothing) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"union", "a.obj", "b.obj", "-o", "u.obj", "--quiet"},
        {"intersect", "a.obj", "c.obj", "-o", "e.obj", "-q"},
        {"check", "a.obj", "-q"},
        {"info", "a.obj", "-q"},
        {"trace", "a.obj", "b.obj", "--op", "union", "-o", "t.json", "-q"}}) {
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0);
    EXPECT_EQ(ended.out + ended.err, "") << arguments[0];
  }
}

TEST_F(Commands, ThreadsAndValidationDoNotChangeResults) {
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "-o", "one.obj", "--threads", "1"}).code, 0);
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "-o", "two.obj", "--threads", "2", "--validate"}).code,
            0);
  EXPECT_EQ(read("one.obj"), read("two.obj"));
  EXPECT_EQ(
      run({"split", "a.obj", "--plane", "1,1,1,-3", "-o", "x.obj", "y.obj", "--validate"}).code, 0);
}

TEST_F(Commands, WhatFloatsCannotHoldIsNotWritten) {
  // In floats, far from the origin, one side of this cube is on its other side.
  FileMesh thin = cube(0, 0, 0);
  for (auto& p : thin.positions) p[0] = 16777216 + p[0] / 8;
  write("thin.obj", content(thin, Format::obj));
  EXPECT_EQ(run({"convert", "thin.obj", "-o", "t.off"}).code, 0);
  const Ended ended = run({"convert", "thin.obj", "-o", "t.stl", "--max-move", "0.5"});
  EXPECT_EQ(ended.code, 3);
  EXPECT_NE(ended.err.find("t.stl: cannot be written: "), std::string::npos) << ended.err;
  EXPECT_FALSE(files().contains("t.stl"));
}

TEST_F(Commands, FilesThatRoundingWouldSpoilAreLegal) {
  // The apex stands on one side of the base, and its floats on the other.
  write("flat.obj",
        "v 1 0 0\nv 0 1 0\nv 0 0 1\nv 0.1 0.2 0.7000000001\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  const Json json = json_of({"convert", "flat.obj", "-o", "t.stl"});
  EXPECT_LE(json["outputs"][0]["rounding"]["largest_move"], 1e-6);
  EXPECT_EQ(run({"check", "t.stl"}).code, 0);
}

}  // namespace
}  // namespace sectile::test
