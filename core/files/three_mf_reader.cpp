// 3MF: a package of XML files. lib3mf reads it; here the items that are built are put together.
//
// Two things that lib3mf lets pass are for others to find: it reads what a coordinate begins with
// ("1,5" is 1), and files made to be malicious can keep it busy without end (components that double
// fifty times).
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

#include "files/append.h"
#include "files/formats.h"
#include "files/lib3mf_handle.h"
#include "sectile/errors.h"
#include "sectile/transform.h"

namespace sectile {
namespace {

// lib3mf's codes of warnings that concern colours, textures, metadata and identifiers of parts, and
// names of elements that it does not know. Whatever else it warns of might change the solids.
constexpr std::array harmless_warnings{
    0x804Eu, 0x804Fu, 0x8050u, 0x8051u, 0x8052u, 0x805Cu, 0x805Du, 0x8070u, 0x8072u,
    0x8075u, 0x8076u, 0x8078u, 0x807Au, 0x807Bu, 0x807Cu, 0x809Cu, 0x80A0u, 0x80A6u,
    0x80A7u, 0x80A8u, 0x80AEu, 0x80B0u, 0x80B2u, 0x80B6u, 0x80B7u, 0x80B8u, 0x80B9u,
    0x80BAu, 0x80BBu, 0x80BCu, 0x80C4u, 0x80C5u, 0x1045u, 0x1047u, 0x1048u};

class ThreeMfReader {
 public:
  explicit ThreeMfReader(std::string_view name) : name_(name) {
    model_ = made("package", NMR::lib3mf_createmodel);
  }

  Model run(std::string_view content) {
    read_package(content);
    Model model;
    model.unit = unit();
    const Lib3mfHandle items = made("build", NMR::lib3mf_model_getbuilditems, model_.get());
    BOOL more = 0;
    while (NMR::lib3mf_builditemiterator_movenext(items.get(), &more) == LIB3MF_OK && more != 0)
      model.meshes.push_back(item(items.get()));
    return model;
  }

 private:
  [[noreturn]] void fail(const std::string& place, const std::string& what) const {
    throw FileError(name_ + ": " + place + ": " + what);
  }
  void require(HRESULT result, const std::string& place) const {
    if (result != LIB3MF_OK) fail(place, "lib3mf gives up");
  }

  template <class... Arguments>
  Lib3mfHandle made(const std::string& place, Arguments... arguments) const {
    Lib3mfHandle handle = lib3mf_handle(arguments...);
    if (!handle) fail(place, "lib3mf gives up");
    return handle;
  }

  void read_package(std::string_view content) {
    const Lib3mfHandle reader = made("package", NMR::lib3mf_model_queryreader, model_.get(), "3mf");
    // It is not changed.
    auto* bytes = reinterpret_cast<BYTE*>(const_cast<char*>(content.data()));
    if (NMR::lib3mf_reader_readfrombuffer(reader.get(), bytes, content.size()) != LIB3MF_OK) {
      DWORD code = 0;
      LPCSTR message = nullptr;
      NMR::lib3mf_getlasterror(reader.get(), &code, &message);
      fail("package", message != nullptr ? message : "not understood");
    }
    check_warnings(reader.get());
  }

  void check_warnings(Lib3mfPointer reader) const {
    DWORD count = 0;
    require(NMR::lib3mf_reader_getwarningcount(reader, &count), "package");
    for (DWORD i = 0; i < count; ++i) {
      DWORD code = 0;
      std::array<char, 256> text{};
      ULONG length = 0;
      NMR::lib3mf_reader_getwarningutf8(reader, i, &code, text.data(), text.size(), &length);
      if (std::find(harmless_warnings.begin(), harmless_warnings.end(), code) ==
          harmless_warnings.end())
        fail("package", std::string(text.data()));
    }
  }

  LengthUnit unit() const {
    DWORD unit = 0;
    require(NMR::lib3mf_model_getunit(model_.get(), &unit), "package");
    switch (unit) {
      case NMR::MODELUNIT_MICROMETER:
        return LengthUnit::micrometer;
      case NMR::MODELUNIT_MILLIMETER:
        return LengthUnit::millimeter;
      case NMR::MODELUNIT_CENTIMETER:
        return LengthUnit::centimeter;
      case NMR::MODELUNIT_INCH:
        return LengthUnit::inch;
      case NMR::MODELUNIT_FOOT:
        return LengthUnit::foot;
      case NMR::MODELUNIT_METER:
        return LengthUnit::meter;
      default:
        fail("package", "unknown unit");
    }
  }

  // An object and where it stands.
  struct Placed {
    Lib3mfHandle object;
    Transform transform;
    bool moved = false;
  };

  NamedMesh item(Lib3mfPointer items) const {
    const Lib3mfHandle item = made("build", NMR::lib3mf_builditemiterator_getcurrent, items);
    Lib3mfHandle object = made("build", NMR::lib3mf_builditem_getobjectresource, item.get());
    NamedMesh result{name_of(object.get()), {}};
    Placed whole{std::move(object), {}, false};
    BOOL moved = 0;
    NMR::MODELTRANSFORM matrix{};
    require(NMR::lib3mf_builditem_hasobjecttransform(item.get(), &moved), "build");
    require(NMR::lib3mf_builditem_getobjecttransform(item.get(), &matrix), "build");
    if (moved != 0) move(whole, matrix);
    build(result, std::move(whole));
    return result;
  }

  // Parts that are still to be built wait on a stack, the next on top.
  void build(NamedMesh& result, Placed&& whole) const {
    std::vector<Placed> waiting;
    waiting.push_back(std::move(whole));
    while (!waiting.empty()) {
      const Placed part = std::move(waiting.back());
      waiting.pop_back();
      if (is_mesh(part.object.get())) {
        append(result.mesh, moved_mesh(part), name_);
        add_colour(result, part.object.get());
        continue;
      }
      std::vector<Placed> parts = components(part.object.get(), part);
      std::move(parts.rbegin(), parts.rend(), std::back_inserter(waiting));
    }
  }

  std::vector<Placed> components(Lib3mfPointer object, const Placed& whole) const {
    const std::string place = place_of(object);
    DWORD count = 0;
    require(NMR::lib3mf_componentsobject_getcomponentcount(object, &count), place);
    std::vector<Placed> parts(count);
    for (DWORD i = 0; i < count; ++i) {
      const Lib3mfHandle component =
          made(place, NMR::lib3mf_componentsobject_getcomponent, object, i);
      parts[i].object = made(place, NMR::lib3mf_component_getobjectresource, component.get());
      BOOL moved = 0;
      NMR::MODELTRANSFORM matrix{};
      require(NMR::lib3mf_component_hastransform(component.get(), &moved), place);
      require(NMR::lib3mf_component_gettransform(component.get(), &matrix), place);
      parts[i].transform = whole.transform;
      parts[i].moved = whole.moved;
      if (moved != 0) move(parts[i], matrix);
    }
    return parts;
  }

  // `inner` applies before the transform that the part has already.
  void move(Placed& part, const NMR::MODELTRANSFORM& inner) const {
    Transform first;
    for (std::size_t row = 0; row < 3; ++row)
      for (std::size_t column = 0; column < 4; ++column) {
        const float value = inner.m_fFields[row][column];
        if (!std::isfinite(value))
          fail(place_of(part.object.get()), "a transform that is not finite");
        first.m[4 * row + column] = value;
      }
    part.transform = part.moved ? part.transform * first : first;
    part.moved = true;
  }

  PolygonMesh moved_mesh(const Placed& part) const {
    PolygonMesh mesh = mesh_of(part.object.get());
    if (!part.moved) return mesh;
    try {
      return transformed(mesh, part.transform);
    } catch (const std::invalid_argument& error) {
      fail(place_of(part.object.get()), std::string("its transform: ") + error.what());
    }
  }

  PolygonMesh mesh_of(Lib3mfPointer object) const {
    const std::string place = place_of(object);
    DWORD beams = 0;
    require(NMR::lib3mf_meshobject_getbeamcount(object, &beams), place);
    if (beams > 0) fail(place, "beam lattices are not read; write the beams as triangles");
    DWORD count = vertex_count(object);
    std::vector<NMR::MODELMESHVERTEX> vertices(count);
    if (count > 0)
      require(NMR::lib3mf_meshobject_getvertices(object, vertices.data(), count, nullptr), place);
    require(NMR::lib3mf_meshobject_gettrianglecount(object, &count), place);
    std::vector<NMR::MODELMESHTRIANGLE> triangles(count);
    if (count > 0)
      require(NMR::lib3mf_meshobject_gettriangleindices(object, triangles.data(), count, nullptr),
              place);
    PolygonMesh mesh;
    mesh.positions.reserve(vertices.size());
    for (const NMR::MODELMESHVERTEX& v : vertices)
      mesh.positions.push_back({v.m_fPosition[0], v.m_fPosition[1], v.m_fPosition[2]});
    mesh.face_sizes.assign(triangles.size(), 3);
    mesh.indices.reserve(3 * triangles.size());
    for (const NMR::MODELMESHTRIANGLE& t : triangles)
      mesh.indices.insert(mesh.indices.end(), std::begin(t.m_nIndices), std::end(t.m_nIndices));
    return mesh;
  }

  // The first part's; without one, that of most triangles.
  void add_colour(NamedMesh& result, Lib3mfPointer object) const {
    const std::optional<MeshColour> whole = colour_of(object);
    const std::map<MeshColour, std::size_t> counts = triangle_colours(object);
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](auto& a, auto& b) { return a.second < b.second; });
    if (!result.colour) {
      if (whole)
        result.colour = whole;
      else if (most != counts.end())
        result.colour = most->first;
    }
    for (const auto& [colour, count] : counts)
      if (colour != result.colour) result.has_more_colours = true;
  }

  // How many triangles have which colour of their own.
  std::map<MeshColour, std::size_t> triangle_colours(Lib3mfPointer object) const {
    const std::string place = place_of(object);
    const Lib3mfHandle property = made(place, NMR::lib3mf_meshobject_createpropertyhandler, object);
    DWORD triangles = 0;
    require(NMR::lib3mf_meshobject_gettrianglecount(object, &triangles), place);
    std::map<MeshColour, std::size_t> counts;
    std::map<std::pair<DWORD, DWORD>, std::size_t> materials;
    for (DWORD i = 0; i < triangles; ++i) {
      NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
      require(NMR::lib3mf_propertyhandler_getpropertytype(property.get(), i, &type), place);
      if (type == NMR::MODELPROPERTYTYPE_COLOR) {
        NMR::MODELMESH_TRIANGLECOLOR_SRGB colour{};
        require(NMR::lib3mf_propertyhandler_getcolor(property.get(), i, &colour), place);
        const NMR::MODELMESHCOLOR_SRGB& corner = colour.m_Colors[0];
        ++counts[{corner.m_Red, corner.m_Green, corner.m_Blue}];
      } else if (type == NMR::MODELPROPERTYTYPE_BASEMATERIALS) {
        std::pair<DWORD, DWORD> material;
        require(NMR::lib3mf_propertyhandler_getbasematerial(property.get(), i, &material.first,
                                                            &material.second),
                place);
        ++materials[material];
      }
    }
    for (const auto& [material, count] : materials)
      counts[material_colour(material.first, material.second, place)] += count;
    return counts;
  }

  // That of the object.
  std::optional<MeshColour> colour_of(Lib3mfPointer object) const {
    const std::string place = place_of(object);
    const Lib3mfHandle property =
        made(place, NMR::lib3mf_object_createdefaultpropertyhandler, object);
    NMR::eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
    require(NMR::lib3mf_defaultpropertyhandler_getpropertytype(property.get(), &type), place);
    if (type == NMR::MODELPROPERTYTYPE_COLOR) {
      NMR::MODELMESHCOLOR_SRGB colour{};
      require(NMR::lib3mf_defaultpropertyhandler_getcolor(property.get(), 0, &colour), place);
      return MeshColour{colour.m_Red, colour.m_Green, colour.m_Blue};
    }
    if (type != NMR::MODELPROPERTYTYPE_BASEMATERIALS) return std::nullopt;
    DWORD group = 0, index = 0;
    require(NMR::lib3mf_defaultpropertyhandler_getbasematerial(property.get(), &group, &index),
            place);
    return material_colour(group, index, place);
  }

  MeshColour material_colour(DWORD group, DWORD index, const std::string& place) const {
    const Lib3mfHandle materials =
        made(place, NMR::lib3mf_model_getbasematerialbyid, model_.get(), group);
    BYTE red = 0, green = 0, blue = 0, alpha = 0;
    require(NMR::lib3mf_basematerial_getdisplaycolor(materials.get(), index, &red, &green, &blue,
                                                     &alpha),
            place);
    return {red, green, blue};
  }

  static bool is_mesh(Lib3mfPointer object) {
    BOOL mesh = 0;
    return NMR::lib3mf_object_ismeshobject(object, &mesh) == LIB3MF_OK && mesh != 0;
  }

  DWORD vertex_count(Lib3mfPointer object) const {
    DWORD count = 0;
    require(NMR::lib3mf_meshobject_getvertexcount(object, &count), place_of(object));
    return count;
  }

  static DWORD id_of(Lib3mfPointer object) {
    DWORD id = 0;
    NMR::lib3mf_resource_getresourceid(object, &id);
    return id;
  }
  static std::string name_of(Lib3mfPointer object) {
    ULONG length = 0;
    if (NMR::lib3mf_object_getnameutf8(object, nullptr, 0, &length) != LIB3MF_OK || length == 0)
      return {};
    std::string name(length + 1, '\0');
    if (NMR::lib3mf_object_getnameutf8(object, name.data(), length + 1, &length) != LIB3MF_OK)
      return {};
    name.resize(length);
    return name;
  }

  // As messages say it.
  static std::string place_of(Lib3mfPointer object) {
    const std::string name = name_of(object);
    return "object " + std::to_string(id_of(object)) + (name.empty() ? "" : " \"" + name + "\"");
  }

  std::string name_;
  Lib3mfHandle model_;
};

}  // namespace

Model read_three_mf(std::string_view content, std::string_view name) {
  return ThreeMfReader(name).run(content);
}

}  // namespace sectile
