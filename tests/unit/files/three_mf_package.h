// 3MF packages made by hand, so that readers meet what writers would never write.
#pragma once

#include <zip.h>

#include <stdexcept>
#include <string>
#include <string_view>

namespace sectile::test {

/// The package whose model is this XML.
inline std::string three_mf_package(std::string_view model) {
  constexpr std::string_view types =
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>"
      "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
      "<Default Extension=\"rels\" "
      "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
      "<Default Extension=\"model\" "
      "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>";
  constexpr std::string_view relations =
      "<?xml version=\"1.0\" encoding=\"utf-8\"?>"
      "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
      "<Relationship Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\" "
      "Target=\"/3D/3dmodel.model\" Id=\"rel0\"/></Relationships>";
  const auto require = [](bool done) {
    if (!done) throw std::runtime_error("libzip gives up");
  };
  zip_source_t* source = zip_source_buffer_create(nullptr, 0, 0, nullptr);
  require(source != nullptr);
  zip_source_keep(source);
  zip_t* archive = zip_open_from_source(source, ZIP_TRUNCATE, nullptr);
  require(archive != nullptr);
  const auto add = [&](const char* name, std::string_view text) {
    require(zip_file_add(archive, name, zip_source_buffer(archive, text.data(), text.size(), 0),
                         0) >= 0);
  };
  add("[Content_Types].xml", types);
  add("_rels/.rels", relations);
  add("3D/3dmodel.model", model);
  require(zip_close(archive) == 0);
  require(zip_source_open(source) == 0);
  zip_stat_t facts;
  require(zip_source_stat(source, &facts) == 0);
  std::string bytes(facts.size, '\0');
  require(zip_source_read(source, bytes.data(), bytes.size()) ==
          static_cast<zip_int64_t>(bytes.size()));
  zip_source_close(source);
  zip_source_free(source);
  return bytes;
}

}  // namespace sectile::test
