// 3MF: what is written reads back, and what others write is understood or refused.
#include <gtest/gtest.h>

#include "file_samples.h"
#include "sectile/solid.h"
#include "three_mf_package.h"

namespace sectile::test {
namespace {

constexpr FileFormat format = FileFormat::three_mf;

Model read_parts(const std::string& content) {
  std::istringstream in(content);
  return read_model(in, format, "file");
}

std::string written_parts(const Model& model) {
  std::ostringstream out;
  write_model(out, format, model, "file");
  return std::move(out).str();
}

std::string why_not_written(const Model& model, FileFormat to = format) {
  try {
    std::ostringstream out;
    write_model(out, to, model, "file");
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

bool holds(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

// ---- the XML that tests put together

const std::string tetrahedron_xml =
    "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/>"
    "<vertex x='0' y='1' z='0'/><vertex x='0' y='0' z='1'/></vertices><triangles>"
    "<triangle v1='0' v2='2' v3='1'/><triangle v1='0' v2='1' v3='3'/>"
    "<triangle v1='0' v2='3' v3='2'/><triangle v1='1' v2='2' v3='3'/></triangles></mesh>";

std::string object(int id, const std::string& content, const std::string& attributes = {}) {
  return "<object id='" + std::to_string(id) + "' type='model' " + attributes + ">" + content +
         "</object>";
}

std::string package(const std::string& objects, const std::string& items,
                    const std::string& attributes = "unit='millimeter'") {
  return three_mf_package(
      "<?xml version='1.0' encoding='utf-8'?><model " + attributes +
      " xml:lang='en-US' xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'>"
      "<resources>" +
      objects + "</resources><build>" + items + "</build></model>");
}

std::string with(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

const std::string item = "<item objectid='1'/>";

PolygonMesh in_floats(PolygonMesh mesh) {
  for (Vec3& p : mesh.positions)
    p = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  return mesh;
}

// ---- written and read back

TEST(ThreeMf, AMeshReadsBackToTheBit) {
  EXPECT_TRUE(same_bits(read(written(tetrahedron(), format), format), tetrahedron()));
}

TEST(ThreeMf, EveryFloatReadsBack) {
  using Limits = std::numeric_limits<float>;
  const float values[] = {1e-7f,
                          1.0f / 3,
                          Limits::denorm_min(),
                          Limits::min(),
                          -0.0f,
                          16777215.0f,
                          33333334.0f,
                          1e9f,
                          -999999936.0f,
                          4.1943043e-3f,
                          0.1f,
                          123456.789f,
                          -2.5e-39f,
                          7e8f + 64,
                          1e-45f,
                          99999.9922f,
                          1.00000012e-30f,
                          5e-6f};
  PolygonMesh mesh = tetrahedron();
  mesh.positions.clear();
  for (const float a : values)
    for (const float b : values) mesh.positions.push_back({a, b, -a});
  EXPECT_TRUE(same_bits(read(written(mesh, format), format), mesh));
}

TEST(ThreeMf, DoublesBecomeTheNearestFloats) {
  PolygonMesh mesh = tetrahedron();
  for (int i = 1; i <= 4; ++i) {
    const double third = 1.0 / (3 * i);
    mesh.positions[static_cast<std::size_t>(i - 1)] = {third, -third, 1e6 + third};
  }
  const PolygonMesh back = read(written(mesh, format), format);
  EXPECT_FALSE(same_bits(back, mesh));
  EXPECT_TRUE(same_bits(back, in_floats(mesh)));
}

TEST(ThreeMf, SolidsKeepTheirNamesOrderAndUnit) {
  Model model;
  model.unit = LengthUnit::inch;
  model.meshes = {{"Schraube <M8> & \"Mutter\" 'ü', 螺栓", tetrahedron()},
                  {"", prism(7)},
                  {"<vertices></vertices><triangles> p:UUID=\"x\"", tetrahedron()},
                  {"", {}}};
  PolygonMesh& second = model.meshes[1].mesh;
  second = in_floats(Solid::from_mesh(second).to_mesh());
  const Model back = read_parts(written_parts(model));
  EXPECT_EQ(back.unit, LengthUnit::inch);
  ASSERT_EQ(back.meshes.size(), model.meshes.size());
  for (std::size_t i = 0; i < model.meshes.size(); ++i) {
    EXPECT_EQ(back.meshes[i].name, model.meshes[i].name);
    EXPECT_TRUE(same_bits(back.meshes[i].mesh, model.meshes[i].mesh)) << i;
  }
}

TEST(ThreeMf, ColoursReadBack) {
  Model model;
  model.meshes = {{"red", tetrahedron(), MeshColour{214, 0, 255}},
                  {"plain", tetrahedron()},
                  {"", tetrahedron(), MeshColour{1, 2, 3}}};
  const Model back = read_parts(written_parts(model));
  ASSERT_EQ(back.meshes.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(back.meshes[i].colour, model.meshes[i].colour) << i;
    EXPECT_TRUE(same_bits(back.meshes[i].mesh, tetrahedron())) << i;
  }
}

TEST(ThreeMf, ColoursOfOthersAreThoseOfTheirMaterials) {
  const std::string materials =
      "<basematerials id='7'><base name='a' displaycolor='#0A0B0C'/>"
      "<base name='b' displaycolor='#FF8000FF'/></basematerials>";
  const Model model =
      read_parts(package(materials + object(1, tetrahedron_xml, "pid='7' pindex='1'"), item));
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].colour, (MeshColour{255, 128, 0}));
}

TEST(ThreeMf, ColoursOfTrianglesAloneGiveTheSolidItsMostFrequentOne) {
  const std::string materials =
      "<basematerials id='7'><base name='a' displaycolor='#0A0B0C'/>"
      "<base name='b' displaycolor='#FF8000FF'/></basematerials>";
  const auto with_colours = [&](const std::string& third) {
    const std::string painted =
        "<mesh><vertices><vertex x='0' y='0' z='0'/><vertex x='1' y='0' z='0'/>"
        "<vertex x='0' y='1' z='0'/><vertex x='0' y='0' z='1'/></vertices><triangles>"
        "<triangle v1='0' v2='2' v3='1' pid='7' p1='1'/>"
        "<triangle v1='0' v2='1' v3='3' pid='7' p1='1'/>"
        "<triangle v1='0' v2='3' v3='2' pid='7' p1='" +
        third +
        "'/>"
        "<triangle v1='1' v2='2' v3='3' pid='7' p1='1'/></triangles></mesh>";
    return read_parts(package(materials + object(1, painted), item)).meshes.at(0);
  };
  const NamedMesh one = with_colours("1"), two = with_colours("0");
  EXPECT_EQ(one.colour, (MeshColour{255, 128, 0}));
  EXPECT_FALSE(one.has_more_colours);
  EXPECT_EQ(two.colour, (MeshColour{255, 128, 0}));
  EXPECT_TRUE(two.has_more_colours);
}

TEST(ThreeMf, EveryUnitReadsBack) {
  for (const LengthUnit unit :
       {LengthUnit::micrometer, LengthUnit::millimeter, LengthUnit::centimeter, LengthUnit::inch,
        LengthUnit::foot, LengthUnit::meter})
    EXPECT_EQ(read_parts(written_parts({unit, {{"a", tetrahedron()}}})).unit, unit);
}

TEST(ThreeMf, TheSameModelGivesTheSameBytes) {
  const Model model{LengthUnit::foot, {{"a", tetrahedron()}, {"b", tetrahedron()}}};
  EXPECT_EQ(written_parts(model), written_parts(model));
}

TEST(ThreeMf, NoMeshesAndEmptyMeshesReadBack) {
  EXPECT_TRUE(read_parts(written_parts({})).meshes.empty());
  EXPECT_TRUE(same_bits(read(written_parts({}), format), {}));
  EXPECT_TRUE(same_bits(read(written({}, format), format), {}));
}

TEST(ThreeMf, SeveralMeshesAreOneSoupWhereOneIsAskedFor) {
  const Model model{LengthUnit::meter, {{"a", tetrahedron()}, {"b", tetrahedron()}}};
  const PolygonMesh mesh = read(written_parts(model), format);
  ASSERT_EQ(mesh.positions.size(), 8u);
  ASSERT_EQ(mesh.face_sizes.size(), 8u);
  for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(mesh.indices[12 + i], mesh.indices[i] + 4);
}

TEST(ThreeMf, OtherFormatsAreModelsOfOneMesh) {
  std::istringstream in("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Model model = read_model(in, FileFormat::obj, "file");
  ASSERT_EQ(model.meshes.size(), 1u);
  EXPECT_EQ(model.meshes[0].name, "");
  EXPECT_EQ(model.meshes[0].mesh.positions.size(), 3u);
  EXPECT_EQ(why_not_written(model, FileFormat::off), "");
  EXPECT_TRUE(
      holds(why_not_written({LengthUnit::inch, {{"a", {}}, {"b", {}}}}, FileFormat::ply_text),
            "only 3MF holds 2 meshes"));
}

// ---- what cannot be written

TEST(ThreeMf, MeshesThatDoNotFitAreRefused) {
  PolygonMesh mesh = tetrahedron();
  mesh.positions[2].z = 1.1e9;
  EXPECT_TRUE(holds(why_not_written({{}, {{"", mesh}}}), "3MF holds no coordinates beyond 1e+09"));
  EXPECT_TRUE(holds(why_not_written({{}, {{"", prism(4)}}}), "3MF holds only triangles"));
  mesh.positions[2].z = std::nan("");
  EXPECT_TRUE(holds(why_not_written({{}, {{"", mesh}}}), "position 2 is not finite"));
}

TEST(ThreeMf, NamesThatAreNoTextAreRefused) {
  for (const char* name : {"a\nb", "\x01", "\xff", "\xc3", "a\xc3z", "\xc0\x80"})
    EXPECT_TRUE(holds(why_not_written({{}, {{name, tetrahedron()}}}), "not text in UTF-8")) << name;
}

// ---- what others write

TEST(ThreeMf, ItemsStandWhereTheirTransformsPutThem) {
  // A quarter turn about z in the order of 3MF: columns of the matrix, then the translation.
  const Model model =
      read_parts(package(object(1, tetrahedron_xml),
                         "<item objectid='1' transform='0 1 0 -1 0 0 0 0 1 5 6 7'/>" + item));
  ASSERT_EQ(model.meshes.size(), 2u);
  const auto& moved = model.meshes[0].mesh.positions;
  EXPECT_EQ(moved[0], (Vec3{5, 6, 7}));
  EXPECT_EQ(moved[1], (Vec3{5, 7, 7}));
  EXPECT_EQ(moved[2], (Vec3{4, 6, 7}));
  EXPECT_EQ(moved[3], (Vec3{5, 6, 8}));
  EXPECT_TRUE(same_bits(model.meshes[1].mesh, tetrahedron()));
}

TEST(ThreeMf, ComponentsAreJoinedUnderTheNameOfTheirObject) {
  const std::string pair =
      "<components><component objectid='1'/>"
      "<component objectid='1' transform='2 0 0 0 2 0 0 0 2 10 0 0'/></components>";
  const std::string moved_pair =
      "<components><component objectid='2' transform='1 0 0 0 1 0 0 0 1 0 100 0'/></components>";
  const Model model = read_parts(
      package(object(1, tetrahedron_xml) + object(2, pair, "name='pair'") +
                  object(3, moved_pair, "name='moved pair'"),
              "<item objectid='2'/><item objectid='3' transform='0 1 0 -1 0 0 0 0 1 0 0 0'/>",
              "unit='micron'"));
  EXPECT_EQ(model.unit, LengthUnit::micrometer);
  ASSERT_EQ(model.meshes.size(), 2u);
  EXPECT_EQ(model.meshes[0].name, "pair");
  EXPECT_EQ(model.meshes[1].name, "moved pair");
  const auto& first = model.meshes[0].mesh.positions;
  ASSERT_EQ(first.size(), 8u);
  EXPECT_EQ(first[1], (Vec3{1, 0, 0}));
  EXPECT_EQ(first[5], (Vec3{12, 0, 0}));
  // Doubled, moved by 10, moved by 100, and only then turned.
  EXPECT_EQ(model.meshes[1].mesh.positions[5], (Vec3{-100, 12, 0}));
  EXPECT_EQ(Solid::from_mesh(model.meshes[1].mesh).volume(), (1 + 8) / 6.0);
}

TEST(ThreeMf, MirroredItemsKeepTheirInside) {
  const Model model = read_parts(package(
      object(1, tetrahedron_xml), "<item objectid='1' transform='-1 0 0 0 1 0 0 0 1 0 0 0'/>"));
  EXPECT_EQ(Solid::from_mesh(model.meshes.at(0).mesh).volume(), 1 / 6.0);
}

TEST(ThreeMf, ObjectsThatAreNotBuiltAreNoSolids) {
  EXPECT_TRUE(read_parts(package(object(1, tetrahedron_xml), "")).meshes.empty());
}

TEST(ThreeMf, WhatIsNoLegalPackageIsRefusedWithTheReason) {
  const auto of = [&](const std::string& mesh) { return package(object(1, mesh), item); };
  const std::string& mesh = tetrahedron_xml;
  const std::string legal = of(mesh);
  EXPECT_EQ(refusal(legal, format), "");
  const struct {
    std::string content, reason;
  } cases[] = {
      {"hello", "ZIP"},
      {legal.substr(0, legal.size() / 2), "ZIP"},
      {three_mf_package("<model"), ""},
      {three_mf_package("<?xml version='1.0'?><html/>"), ""},
      {of(with(mesh, "x='1'", "x='nan'")), "Invalid Model Coordinates"},
      {of(with(mesh, "x='1'", "x='1e10'")), "Invalid Model Coordinates"},
      {of(with(mesh, "x='1'", "")), "missing a coordinate"},
      {of(with(mesh, "v1='1'", "v1='4'")), "Invalid model node index"},
      {of(with(mesh, "v1='1'", "v1='-1'")), "Invalid model node index"},
      {of(with(mesh, "v1='1'", "v1='2'")), "Invalid Model Coordinate Indices"},
      {package(object(1, mesh), "<item objectid='7'/>"), "Build item"},
      {package(object(1, mesh) + object(1, mesh), item), "Duplicate Resource ID"},
      {package(object(1, mesh), item, "unit='lightyear'"), "unit"},
      {package(object(1, mesh), item, "xmlns:q='http://q.org' requiredextensions='q'"),
       "required extension"},
      {package(object(1, mesh), "<item objectid='1' transform='1 0 0 0 1 0 0 0 1 5 6'/>"),
       "Not enough values"},
      {package(object(1, mesh, "name='bolt'"),
               "<item objectid='1' transform='nan 0 0 0 1 0 0 0 1 5 6 7'/>"),
       "object 1 \"bolt\": a transform that is not finite"},
      {package(object(1, mesh), "<item objectid='1' transform='1 0 0 0 1 0 0 0 0 5 6 7'/>"),
       "object 1: its transform: "},
      {package(object(2, "<components><component objectid='2'/></components>"),
               "<item objectid='2'/>"),
       "Component"},
  };
  for (const auto& [content, reason] : cases) {
    const std::string said = refusal(content, format);
    EXPECT_TRUE(said.starts_with("file: ") && said.size() > 12) << reason << ": " << said;
    EXPECT_TRUE(holds(said, reason)) << reason << " but: " << said;
  }
}

}  // namespace
}  // namespace sectile::test
