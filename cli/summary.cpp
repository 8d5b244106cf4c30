#include "summary.h"

#include <nlohmann/json.hpp>

#include <sstream>

namespace sectile::cli {
namespace {

bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ux = b.x - a.x, uy = b.y - a.y, uz = b.z - a.z;
  const double vx = c.x - a.x, vy = c.y - a.y, vz = c.z - a.z;
  return uy * vz == uz * vy && uz * vx == ux * vz && ux * vy == uy * vx;
}

}  // namespace

Summary summarize(const Solid& solid, const PolygonMesh& mesh) {
  Summary s;
  s.counts = solid.counts();
  s.triangles = mesh.face_sizes.size();
  s.volume = solid.volume();
  s.area = solid.area();
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
    if (has_no_area(mesh.positions[mesh.indices[i]], mesh.positions[mesh.indices[i + 1]],
                    mesh.positions[mesh.indices[i + 2]]))
      ++s.degenerate;
  return s;
}

std::string in_words(const std::string& name, const Summary& s) {
  std::ostringstream out;
  out.precision(17);
  out << name << ": " << s.counts.vertices << " vertices, " << s.counts.edges << " edges, "
      << s.counts.faces << " faces, " << s.counts.shells << " shells, genus " << s.counts.genus
      << "; volume " << s.volume << ", area " << s.area << "; " << s.triangles << " triangles";
  if (s.degenerate > 0)
    out << ", of which rounding to doubles left " << s.degenerate << " without area";
  out << '\n';
  return out.str();
}

std::string in_json(const std::string& name, const Summary& s) {
  return nlohmann::ordered_json{{"name", name},
                                {"vertices", s.counts.vertices},
                                {"edges", s.counts.edges},
                                {"faces", s.counts.faces},
                                {"loops", s.counts.loops},
                                {"shells", s.counts.shells},
                                {"genus", s.counts.genus},
                                {"volume", s.volume},
                                {"area", s.area},
                                {"triangles", s.triangles},
                                {"degenerate_triangles", s.degenerate}}
             .dump() +
         "\n";
}

}  // namespace sectile::cli
