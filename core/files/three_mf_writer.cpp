// 3MF: lib3mf makes the package, its parts and what ties them together. But it writes coordinates
// with six decimals: a millionth becomes nothing, 1/3 another float, and faces that were legal
// cross. And it gives every part an identifier by chance. So it writes empty objects, and
// here their meshes are put into its XML, in numbers that read back as the same floats, and the
// identifiers are taken out.
#include <zip.h>

#include <array>
#include <limits>

#include "files/formats.h"
#include "files/lib3mf_handle.h"
#include "files/writable.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

constexpr const char* model_part = "3D/3dmodel.model";
// lib3mf reads no larger ones.
constexpr float most_coordinate = 1e9f;

[[noreturn]] void fail(std::string_view name, const std::string& why) {
  throw FileError(std::string(name) + ": cannot write: " + why);
}

// ---- the package with empty objects

DWORD lib3mf_unit(LengthUnit unit) {
  switch (unit) {
    case LengthUnit::micrometer:
      return NMR::MODELUNIT_MICROMETER;
    case LengthUnit::millimeter:
      return NMR::MODELUNIT_MILLIMETER;
    case LengthUnit::centimeter:
      return NMR::MODELUNIT_CENTIMETER;
    case LengthUnit::inch:
      return NMR::MODELUNIT_INCH;
    case LengthUnit::foot:
      return NMR::MODELUNIT_FOOT;
    case LengthUnit::meter:
      break;
  }
  return NMR::MODELUNIT_METER;
}

// lib3mf passes on any bytes, and XML knows no control characters.
bool is_text(std::string_view name) {
  int more = 0;  // bytes of a UTF-8 character that are still to come
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (more > 0) {
      if ((byte & 0xC0) != 0x80) return false;
      --more;
    } else if (byte >= 0x80) {
      more = byte >= 0xF0 ? 3 : byte >= 0xE0 ? 2 : 1;
      if (byte < 0xC2 || byte > 0xF4) return false;
    } else if (byte < 0x20) {
      return false;
    }
  }
  return more == 0;
}

class EmptyPackage {
 public:
  explicit EmptyPackage(std::string_view name) : name_(name) {
    model_ = made(NMR::lib3mf_createmodel);
  }

  std::vector<char> run(const Model& model) {
    require(NMR::lib3mf_model_setunit(model_.get(), lib3mf_unit(model.unit)));
    for (const NamedMesh& mesh : model.meshes) add_object(mesh);
    const Lib3mfHandle writer = made(NMR::lib3mf_model_querywriter, model_.get(), "3mf");
    ULONG64 size = 0;
    require(NMR::lib3mf_writer_getstreamsize(writer.get(), &size));
    std::vector<char> bytes(size);
    require(NMR::lib3mf_writer_writetobuffer(writer.get(), reinterpret_cast<BYTE*>(bytes.data()),
                                             size));
    return bytes;
  }

 private:
  void require(HRESULT result) const {
    if (result != LIB3MF_OK) fail(name_, "lib3mf gives up");
  }

  template <class... Arguments>
  Lib3mfHandle made(Arguments... arguments) const {
    Lib3mfHandle handle = lib3mf_handle(arguments...);
    if (!handle) fail(name_, "lib3mf gives up");
    return handle;
  }

  void add_object(const NamedMesh& mesh) {
    const std::string& title = mesh.name;
    if (!is_text(title)) fail(name_, "the name of a solid is not text in UTF-8");
    const Lib3mfHandle object = made(NMR::lib3mf_model_addmeshobject, model_.get());
    if (!title.empty()) require(NMR::lib3mf_object_setnameutf8(object.get(), title.c_str()));
    if (mesh.colour) paint(object.get(), *mesh.colour, title);
    made(NMR::lib3mf_model_addbuilditem, model_.get(), object.get(), nullptr);
  }

  // A material for each, called like its object.
  void paint(Lib3mfPointer object, const MeshColour& colour, const std::string& title) const {
    const Lib3mfHandle materials = made(NMR::lib3mf_model_addbasematerialgroup, model_.get());
    DWORD index = 0, group = 0;
    require(NMR::lib3mf_basematerial_addmaterialutf8(materials.get(),
                                                     title.empty() ? "colour" : title.c_str(),
                                                     colour[0], colour[1], colour[2], &index));
    require(NMR::lib3mf_basematerial_getresourceid(materials.get(), &group));
    const Lib3mfHandle property = made(NMR::lib3mf_object_createdefaultpropertyhandler, object);
    require(NMR::lib3mf_defaultpropertyhandler_setbasematerial(property.get(), group, index));
  }

  std::string_view name_;
  Lib3mfHandle model_;
};

// ---- the meshes

void write_vertices(Sink& out, const PolygonMesh& mesh, std::string_view name) {
  const auto number = [&](double value) {
    return writable_float(value, name, "3MF", most_coordinate);
  };
  for (const Vec3& p : mesh.positions)
    out << "<vertex x=\"" << number(p.x) << "\" y=\"" << number(p.y) << "\" z=\"" << number(p.z)
        << "\"/>\n";
}

void write_triangles(Sink& out, const PolygonMesh& mesh) {
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
    out << "<triangle v1=\"" << mesh.indices[i] << "\" v2=\"" << mesh.indices[i + 1] << "\" v3=\""
        << mesh.indices[i + 2] << "\"/>\n";
}

// Copies the XML of the package up to and with `mark`. In names lib3mf has escaped what marks hold.
void copy_with(Sink& out, std::string_view& rest, std::string_view mark) {
  const std::size_t end = rest.find(mark);
  if (end == std::string_view::npos)
    throw InternalError("lib3mf has written 3MF without " + std::string(mark));
  out << rest.substr(0, end + mark.size());
  rest.remove_prefix(end + mark.size());
}

std::string without_identifiers(std::string_view xml) {
  constexpr std::string_view identifier = " p:UUID=\"";
  std::string kept;
  while (true) {
    const std::size_t at = xml.find(identifier);
    kept += xml.substr(0, at);
    if (at == std::string_view::npos) return kept;
    xml.remove_prefix(at + identifier.size());
    xml.remove_prefix(xml.find('"') + 1);
  }
}

std::string filled(const std::string& empty, const Model& model, std::string_view name) {
  std::string xml;
  Sink out([&](std::string_view text) { xml += text; });
  std::string_view rest = empty;
  for (const NamedMesh& part : model.meshes) {
    copy_with(out, rest, "<vertices>");
    write_vertices(out, part.mesh, name);
    copy_with(out, rest, "<triangles>");
    write_triangles(out, part.mesh);
  }
  out << rest;
  out.finish();
  return xml;
}

// ---- a package in memory, one part of which is replaced

struct DiscardZip {
  void operator()(zip_t* archive) const { zip_discard(archive); }
};
struct FreeSource {
  void operator()(zip_source_t* source) const { zip_source_free(source); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};

class Package {
 public:
  Package(const std::vector<char>& bytes, std::string_view name) : name_(name) {
    source_.reset(zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr));
    require(source_ != nullptr);
    zip_source_keep(source_.get());  // the archive takes one, this object keeps one
    archive_.reset(zip_open_from_source(source_.get(), 0, nullptr));
    if (!archive_) zip_source_free(source_.get());
    require(archive_ != nullptr);
    const zip_int64_t part = zip_name_locate(archive_.get(), model_part, 0);
    require(part >= 0);
    part_ = static_cast<zip_uint64_t>(part);
  }

  std::string model() const {
    zip_stat_t facts;
    require(zip_stat_index(archive_.get(), part_, 0, &facts) == 0);
    const std::unique_ptr<zip_file_t, CloseFile> file(zip_fopen_index(archive_.get(), part_, 0));
    require(file != nullptr);
    std::string text(facts.size, '\0');
    require(zip_fread(file.get(), text.data(), text.size()) ==
            static_cast<zip_int64_t>(text.size()));
    return text;
  }

  // `text` must live until the bytes are taken. The date is that of lib3mf's parts: none.
  void replace_model(const std::string& text) {
    zip_source_t* content = zip_source_buffer(archive_.get(), text.data(), text.size(), 0);
    require(content != nullptr);
    if (zip_file_replace(archive_.get(), part_, content, 0) != 0) {
      zip_source_free(content);
      require(false);
    }
    constexpr zip_uint16_t date = 1 << 5 | 1;  // the first of January 1980
    require(zip_file_set_dostime(archive_.get(), part_, 0, date, 0) == 0);
    // More would take seconds for little.
    require(zip_set_file_compression(archive_.get(), part_, ZIP_CM_DEFLATE, 1) == 0);
  }

  void write(Sink& out) {
    require(zip_close(archive_.get()) == 0);
    archive_.release();
    require(zip_source_open(source_.get()) == 0);
    std::array<char, 1 << 16> piece;
    while (true) {
      const zip_int64_t size = zip_source_read(source_.get(), piece.data(), piece.size());
      require(size >= 0);
      if (size == 0) break;
      out << std::string_view(piece.data(), static_cast<std::size_t>(size));
    }
    require(zip_source_close(source_.get()) == 0);
  }

 private:
  void require(bool done) const {
    if (!done) fail(name_, "the package cannot be made; is there too little memory?");
  }

  std::string_view name_;
  std::unique_ptr<zip_source_t, FreeSource> source_;
  std::unique_ptr<zip_t, DiscardZip> archive_;
  zip_uint64_t part_ = 0;
};

}  // namespace

void write_three_mf(Sink& out, const Model& model, std::string_view name) {
  for (const NamedMesh& part : model.meshes) require_triangles(part.mesh, name, "3MF");
  const std::vector<char> empty = EmptyPackage(name).run(model);
  Package package(empty, name);
  const std::string xml = filled(without_identifiers(package.model()), model, name);
  package.replace_model(xml);
  package.write(out);
}

}  // namespace sectile
