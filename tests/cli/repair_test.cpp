// sectile repair, and --repair of the Boolean commands.
#include <nlohmann/json.hpp>

#include "mesh_files.h"
#include "program.h"
#include "sectile/files.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"

namespace sectile::test {
namespace {

using Json = nlohmann::json;

FileMesh turned_over(FileMesh mesh) {
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  return mesh;
}

FileMesh without_last_face(FileMesh mesh) {
  mesh.faces.pop_back();
  return mesh;
}

class RepairCommand : public ProgramTest {
 protected:
  void SetUp() override {
    write("a.obj", content(cube(0, 0, 0), Format::obj));
    write("b.obj", content(cube(1, 1, 1), Format::obj));
    write("crossing.obj", content(together(cube(0, 0, 0), cube(1, 1, 1)), Format::obj));
    write("inverse.obj", content(together(cube(0, 0, 0), turned_over(cube(1, 1, 1))), Format::obj));
    write("open.obj", content(without_last_face(cube(0, 0, 0)), Format::obj));
  }

  Json json_of(std::vector<std::string> arguments, int code = 0) const {
    arguments.push_back("--json");
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, code) << ended.err;
    const Json json = Json::parse(ended.out, nullptr, false);
    EXPECT_FALSE(json.is_discarded()) << ended.out;
    EXPECT_EQ(json["exit_code"], code);
    return json;
  }
  double volume_of(const std::string& file) const {
    return json_of({"check", file}).value("volume", -1.0);
  }
  static Json change(const Json& json, const std::string& kind) {
    for (const Json& c : json["changes"])
      if (c["kind"] == kind) return c;
    return {};
  }
};

TEST_F(RepairCommand, ALegalMeshStaysAsItIs) {
  const Ended ended = run({"repair", "a.obj", "-o", "r.obj"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_EQ(ended.out.substr(0, ended.out.find('\n')), "nothing to repair");
  EXPECT_EQ(volume_of("r.obj"), 8);
}

TEST_F(RepairCommand, PartsThatCrossAreUnited) {
  EXPECT_EQ(run({"check", "crossing.obj"}).code, 1);
  const Json json = json_of({"repair", "crossing.obj", "-o", "r.off"});
  EXPECT_EQ(json["command"], "repair");
  EXPECT_EQ(json["result"]["volume"], 15);
  EXPECT_EQ(json["outputs"][0]["file"], "r.off");
  EXPECT_EQ(json["outputs"][0]["volume"], 15);
  EXPECT_EQ(change(json, "divided_faces")["count"], 6);
  EXPECT_FALSE(change(json, "divided_faces")["message"].get<std::string>().empty());
  EXPECT_EQ(change(json, "divided_faces")["where"].size(), 3u);
  EXPECT_EQ(volume_of("r.off"), 15);
}

TEST_F(RepairCommand, SeveralInputsAreOneMesh) {
  const Json json = json_of({"repair", "a.obj", "b.obj", "-o", "r.ply"});
  EXPECT_EQ(json["inputs"], (Json{"a.obj", "b.obj"}));
  EXPECT_EQ(volume_of("r.ply"), 15);
}

TEST_F(RepairCommand, RulesSayWhatIsMaterial) {
  const auto volume = [&](const std::string& file, const std::string& rule) {
    return json_of({"repair", file, "-o", "r.obj", "--rule", rule})["result"]["volume"];
  };
  EXPECT_EQ(volume("crossing.obj", "positive"), 15);
  EXPECT_EQ(volume("crossing.obj", "nonzero"), 15);
  EXPECT_EQ(volume("crossing.obj", "odd"), 14);
  // Where one part is inside out, both cancel each other.
  EXPECT_EQ(volume("inverse.obj", "positive"), 7);
  EXPECT_EQ(volume("inverse.obj", "nonzero"), 14);
  EXPECT_EQ(volume("inverse.obj", "odd"), 14);
}

TEST_F(RepairCommand, ARuleThatIsNoneIsWrongUsage) {
  EXPECT_EQ(run({"repair", "a.obj", "-o", "r.obj", "--rule", "even"}).code, 2);
  EXPECT_FALSE(exists("r.obj"));
}

TEST_F(RepairCommand, HolesAreRefusedWithPlaceAndLength) {
  const Ended ended = run({"repair", "open.obj", "-o", "r.obj"});
  EXPECT_EQ(ended.code, 1);
  EXPECT_NE(ended.err.find("open.obj"), std::string::npos) << ended.err;
  EXPECT_NE(ended.err.find("1 hole: 4 edges of length 8 at ("), std::string::npos) << ended.err;
  EXPECT_FALSE(exists("r.obj"));
  const Json json = json_of({"repair", "open.obj", "-o", "r.obj"}, 1);
  EXPECT_EQ(json["error"]["kind"], "not_legal");
}

TEST_F(RepairCommand, HolesAreClosedOnRequest) {
  const Json json = json_of({"repair", "open.obj", "-o", "r.obj", "--close-holes"});
  EXPECT_EQ(change(json, "closed_holes")["count"], 1);
  ASSERT_EQ(json["holes"].size(), 1u);
  EXPECT_EQ(json["holes"][0]["edges"], 4);
  EXPECT_EQ(json["holes"][0]["length"], 8);
  EXPECT_EQ(volume_of("r.obj"), 8);
  const Ended ended = run({"repair", "open.obj", "-o", "r.obj", "--close-holes"});
  EXPECT_NE(ended.out.find("hole of 4 edges, length 8"), std::string::npos) << ended.out;
}

TEST_F(RepairCommand, BordersAreStitchedWithinADistance) {
  // The lid lies a little higher than the box, with vertices of its own.
  FileMesh box = cube(0, 0, 0), lid = box;
  box.faces.pop_back();
  lid.faces.assign(1, cube(0, 0, 0).faces.back());
  for (auto& p : lid.positions) p[0] += 0.001;
  write("gap.obj", content(together(box, lid), Format::obj));
  EXPECT_EQ(run({"repair", "gap.obj", "-o", "r.obj"}).code, 1);
  EXPECT_EQ(run({"repair", "gap.obj", "-o", "r.obj", "--stitch", "0.0001"}).code, 1);
  const Json json = json_of({"repair", "gap.obj", "-o", "r.obj", "--stitch", "0.01"});
  EXPECT_EQ(change(json, "stitched_vertices")["count"], 4);
  EXPECT_NEAR(volume_of("r.obj"), 8, 0.01);
  EXPECT_EQ(run({"repair", "gap.obj", "-o", "r.obj", "--stitch", "-1"}).code, 2);
}

TEST_F(RepairCommand, ADryRunWritesNothing) {
  const std::set<std::string> before = files();
  const Ended ended = run({"repair", "crossing.obj", "--dry-run"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE(ended.out.find("divided"), std::string::npos) << ended.out;
  const Json json = json_of({"repair", "crossing.obj", "--dry-run"});
  EXPECT_EQ(json["dry_run"], true);
  EXPECT_EQ(json["outputs"].size(), 0u);
  EXPECT_EQ(json["result"]["volume"], 15);
  EXPECT_EQ(run({"repair", "crossing.obj", "--dry-run", "-o", "r.obj"}).code, 0);
  EXPECT_EQ(files(), before);
}

TEST_F(RepairCommand, WithoutOutputOnlyADryRunMakesSense) {
  EXPECT_EQ(run({"repair", "a.obj"}).code, 2);
  EXPECT_EQ(run({"repair"}).code, 2);
}

TEST_F(RepairCommand, FilesThatAreNotThere) {
  EXPECT_EQ(run({"repair", "none.obj", "-o", "r.obj"}).code, 3);
  EXPECT_EQ(run({"repair", "a.obj", "-o", "none/r.obj"}).code, 3);
  write("broken.obj", "v 1 2 x\n");
  EXPECT_EQ(run({"repair", "broken.obj", "-o", "r.obj"}).code, 3);
}

TEST_F(RepairCommand, StandardInputAndOutput) {
  const Ended ended = run({"repair", "-", "-o", "-"}, read("crossing.obj"));
  EXPECT_EQ(ended.code, 0) << ended.err;
  write("piped.obj", ended.out);
  EXPECT_EQ(volume_of("piped.obj"), 15);
}

TEST_F(RepairCommand, AllSolidsOfA3mfFileAreOneMesh) {
  Model model{LengthUnit::inch, {}};
  model.meshes = {{"body", block({0, 0, 0}, {2, 2, 2}).to_mesh()},
                  {"lid", block({1, 1, 1}, {3, 3, 3}).to_mesh()}};
  write_model(path("parts.3mf"), model);
  EXPECT_EQ(json_of({"repair", "parts.3mf", "-o", "r.3mf"})["result"]["volume"], 15);
  EXPECT_EQ(read_model(path("r.3mf")).unit, LengthUnit::inch);
  EXPECT_EQ(volume_of("r.3mf"), 15);
}

TEST_F(RepairCommand, BooleansRepairTheirOperands) {
  EXPECT_EQ(run({"subtract", "crossing.obj", "a.obj", "-o", "s.obj"}).code, 1);
  const Ended ended = run({"subtract", "crossing.obj", "a.obj", "-o", "s.obj", "--repair"});
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_NE((ended.out + ended.err).find("divided"), std::string::npos);
  EXPECT_EQ(volume_of("s.obj"), 7);
}

TEST_F(RepairCommand, MaxMoveRefusesWhatWouldMoveFarther) {
  write("turned.obj", content(bulged_cube(3, 0.1), Format::obj));
  const Ended ended = run({"repair", "turned.obj", "-o", "r.stl", "--max-move", "0"});
  EXPECT_EQ(ended.code, 3) << ended.out;
  EXPECT_NE(ended.err.find("would move"), std::string::npos) << ended.err;
  EXPECT_FALSE(exists("r.stl"));
  EXPECT_EQ(run({"repair", "turned.obj", "-o", "r.stl", "--max-move", "0.001"}).code, 0);
}

TEST_F(RepairCommand, SeparateTouchingMakesAManifold) {
  write("corner.obj", content(together(cube(0, 0, 0), cube(2, 2, 2)), Format::obj));
  const auto vertices = [&](const std::string& file) {
    std::set<std::array<double, 3>> places;
    for (const Vec3& p : read_mesh(path(file)).positions) places.insert({p.x, p.y, p.z});
    return places.size();
  };
  EXPECT_EQ(run({"repair", "corner.obj", "-o", "r.off"}).code, 0);
  EXPECT_EQ(vertices("r.off"), 15u);
  const Json json = json_of({"repair", "corner.obj", "-o", "m.off", "--separate-touching"});
  EXPECT_EQ(json["outputs"][0]["rounding"]["separated"], 1);
  EXPECT_EQ(vertices("m.off"), 16u);
  EXPECT_EQ(run({"union", "a.obj", "corner.obj", "-o", "u.off", "--separate-touching"}).code, 0);
  EXPECT_EQ(vertices("u.off"), 16u);
}

}  // namespace
}  // namespace sectile::test
