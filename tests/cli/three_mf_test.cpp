// 3MF on the command line: several solids in a file, their names and unit.
#include <nlohmann/json.hpp>

#include "mesh_files.h"
#include "program.h"
#include "sectile/files.h"
#include "sectile/primitives.h"
#include "sectile/solid.h"

namespace sectile::test {
namespace {

using Json = nlohmann::json;

class ThreeMfFiles : public ProgramTest {
 protected:
  void SetUp() override {
    write("a.obj", content(cube(0, 0, 0), Format::obj));
    write("b.obj", content(cube(1, 1, 1), Format::obj));
    // Two solids that overlap, and one without a name.
    Model model{LengthUnit::inch, {}};
    model.meshes = {{"body", block({0, 0, 0}, {2, 2, 2}).to_mesh()},
                    {"the lid", block({1, 1, 1}, {3, 3, 3}).to_mesh()},
                    {"", block({10, 0, 0}, {11, 1, 1}).to_mesh()}};
    write_model(path("parts.3mf"), model);
  }

  Json json_of(std::vector<std::string> arguments) const {
    arguments.push_back("--json");
    const Ended ended = run(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return Json::parse(ended.out, nullptr, false);
  }
};

TEST_F(ThreeMfFiles, ResultsAreWrittenAndReadAgain) {
  EXPECT_EQ(run({"union", "a.obj", "b.obj", "-o", "u.3mf"}).code, 0);
  EXPECT_EQ(json_of({"check", "u.3mf"})["volume"], 15);
  EXPECT_EQ(run({"convert", "u.3mf", "-o", "u.obj"}).code, 0);
  EXPECT_EQ(json_of({"check", "u.obj"})["volume"], 15);
  EXPECT_EQ(read_model(path("u.3mf")).unit, LengthUnit::millimeter);
}

TEST_F(ThreeMfFiles, OneSolidOfSeveralIsAnOperand) {
  const auto volume = [&](const std::string& a, const std::string& b) {
    return json_of({"union", a, b, "-o", "u.3mf"})["outputs"][0]["volume"];
  };
  EXPECT_EQ(volume("parts.3mf#body", "parts.3mf#the lid"), 15);
  EXPECT_EQ(volume("parts.3mf#1", "parts.3mf#3"), 9);
  EXPECT_EQ(read_model(path("u.3mf")).unit, LengthUnit::inch);
}

TEST_F(ThreeMfFiles, ASolidThatIsNotThereIsAnErrorOfTheFile) {
  for (const char* name : {"parts.3mf#nut", "parts.3mf#0", "parts.3mf#4", "parts.3mf#1x"}) {
    const Ended ended = run({"check", name});
    EXPECT_EQ(ended.code, 3) << name;
    EXPECT_NE(ended.err.find("there is no solid"), std::string::npos) << ended.err;
  }
  write_model(path("twins.3mf"), {LengthUnit::inch, {{"x", {}}, {"x", {}}}});
  EXPECT_NE(run({"check", "twins.3mf#x"}).err.find("use their numbers"), std::string::npos);
  EXPECT_EQ(run({"check", "twins.3mf#2"}).code, 0);
}

TEST_F(ThreeMfFiles, ANumberSignInAnotherNameIsPartOfIt) {
  write("c#1.obj", content(cube(0, 0, 0), Format::obj));
  std::filesystem::copy(path("parts.3mf"), path("odd.3mf#3mf.3mf"));
  EXPECT_EQ(json_of({"check", "c#1.obj"})["volume"], 8);
  EXPECT_EQ(json_of({"check", "odd.3mf#3mf.3mf#3"})["volume"], 1);
}

TEST_F(ThreeMfFiles, ConversionKeepsSolidsNamesAndUnit) {
  const Json json = json_of({"convert", "parts.3mf", "-o", "again.3mf"});
  ASSERT_EQ(json["outputs"].size(), 3u);
  EXPECT_EQ(json["outputs"][1]["part"], "the lid");
  EXPECT_EQ(json["outputs"][2]["part"], "3");
  EXPECT_EQ(json["outputs"][2]["volume"], 1);
  EXPECT_EQ(json["outputs"][2]["file"], "again.3mf");
  const Model model = read_model(path("again.3mf"));
  EXPECT_EQ(model.unit, LengthUnit::inch);
  ASSERT_EQ(model.meshes.size(), 3u);
  EXPECT_EQ(model.meshes[0].name, "body");
  EXPECT_EQ(Solid::from_mesh(model.meshes[1].mesh).volume(), 8);
}

TEST_F(ThreeMfFiles, InformationListsAllSolids) {
  const Json json = json_of({"info", "parts.3mf"});
  EXPECT_EQ(json["format"], "3mf");
  EXPECT_EQ(json["unit"], "inch");
  EXPECT_EQ(json["faces"], 36);
  ASSERT_EQ(json["solids"].size(), 3u);
  EXPECT_EQ(json["solids"][1]["number"], 2);
  EXPECT_EQ(json["solids"][1]["name"], "the lid");
  EXPECT_EQ(json["solids"][1]["solid"]["volume"], 8);
  const std::string words = run({"info", "parts.3mf"}).out;
  EXPECT_NE(words.find("unit: inch"), std::string::npos);
  EXPECT_NE(words.find("2: the lid\n"), std::string::npos);
}

TEST_F(ThreeMfFiles, UnitsAreNotMixed) {
  write_model(path("mm.3mf"),
              {LengthUnit::millimeter, {{"", block({0, 0, 0}, {1, 1, 1}).to_mesh()}}});
  const Ended ended = run({"union", "a.obj", "parts.3mf#3", "mm.3mf", "-o", "u.3mf"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("mm.3mf is in the unit millimeter"), std::string::npos) << ended.err;
  EXPECT_FALSE(exists("u.3mf"));
}

TEST_F(ThreeMfFiles, StandardInputAndOutput) {
  const Ended piped =
      run({"convert", "-", "-o", "-", "--input-format", "3mf", "--output-format", "3mf"},
          read("parts.3mf"));
  EXPECT_EQ(piped.code, 0) << piped.err;
  write("piped.3mf", piped.out);
  EXPECT_EQ(read_model(path("piped.3mf")).meshes.size(), 3u);
}

TEST_F(ThreeMfFiles, FacesCannotBeKept) {
  const Ended ended = run({"convert", "a.obj", "-o", "a.3mf", "--keep-faces"});
  EXPECT_EQ(ended.code, 2);
  EXPECT_FALSE(exists("a.3mf"));
}

}  // namespace
}  // namespace sectile::test
