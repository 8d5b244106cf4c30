#include "evaluation/mesh_defects.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <map>

#include "evaluation/mesh_edges.h"
#include "picture/surface_mesh.h"
#include "sectile/repair.h"

namespace sectile::viewer {
namespace {

using Kind = MeshDefect::Kind;
using Change = RepairChange::Kind;

glm::dvec3 to_glm(const Vec3& p) {
  return {p.x, p.y, p.z};
}

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.5g", value);
  return text;
}

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

/// What a change that would repair the mesh says about the mesh as it is.
struct Words {
  Kind kind;
  const char *one, *many;
};

std::optional<Words> words_for(Change kind) {
  switch (kind) {
    case Change::removed_flat:
      return Words{Kind::degenerate, "face has no area", "faces have no area"};
    case Change::removed_copies:
      return Words{Kind::degenerate, "face repeats another one", "faces repeat others"};
    case Change::turned_faces:
      return Words{Kind::orientation, "face is turned the wrong way round",
                   "faces are turned the wrong way round"};
    case Change::turned_parts:
      return Words{Kind::orientation, "part is inside out", "parts are inside out"};
    default:
      return std::nullopt;
  }
}

class DefectFinder {
 public:
  DefectFinder(const PolygonMesh& mesh, const InvalidSolid& refusal,
               const std::atomic<bool>* cancel)
      : mesh_(mesh), refusal_(refusal), cancel_(cancel) {
    first_corner_.reserve(mesh.face_sizes.size());
    std::size_t corner = 0;
    for (const std::uint32_t size : mesh.face_sizes) {
      first_corner_.push_back(corner);
      corner += size;
    }
  }

  MeshDefects run() {
    drawable_ = can_be_drawn(mesh_);
    if (drawable_) {
      look_at_edges();
      for (const FaceContact& contact : refusal_.contacts()) add_contact(contact);
      add_what_repair_finds();
    }
    if (found_.list.empty()) add_refusal();
    std::stable_sort(found_.list.begin(), found_.list.end(),
                     [](const auto& a, const auto& b) { return a.kind < b.kind; });
    if (drawable_) add_surfaces();
    return std::move(found_);
  }

 private:
  void stop_if_cancelled() const {
    if (cancel_ && *cancel_) throw Cancelled();
  }

  void add(MeshDefect defect) {
    if (defect.place) defect.bounds.add(*defect.place);
    for (const std::uint32_t f : defect.faces) add_bounds(f, defect.bounds);
    for (const glm::vec3& p : defect.edges) defect.bounds.add(glm::dvec3(p));
    found_.list.push_back(std::move(defect));
  }

  void add_bounds(std::uint32_t face, Bounds& bounds) const {
    if (!drawable_ || face >= mesh_.face_sizes.size()) return;
    for (std::size_t i = 0; i < mesh_.face_sizes[face]; ++i)
      bounds.add(to_glm(mesh_.positions[mesh_.indices[first_corner_[face] + i]]));
  }

  void add_contact(const FaceContact& contact) {
    MeshDefect defect;
    defect.kind = Kind::contact;
    defect.text = capitalised(contact.what);
    defect.place = to_glm(contact.where);
    for (const std::uint32_t f : {contact.face, contact.other})
      if (f != no_element && (defect.faces.empty() || defect.faces[0] != f))
        defect.faces.push_back(f);
    add(std::move(defect));
  }

  // The report of a repair that is not wanted yet says what a repair would have to do.
  void add_what_repair_finds() {
    const RepairReport report = report_of(false);
    for (const Hole& hole : report.holes) add_hole(hole);
    for (const RepairChange& change : report.changes) add_change(change);
    if (!report.holes.empty()) add_contacts_beside_holes();
    const bool told = std::any_of(found_.list.begin(), found_.list.end(),
                                  [](const auto& d) { return d.kind == Kind::orientation; });
    if (!told && !edges_.contradictions.empty()) add_refusal();
  }

  RepairReport report_of(bool close_holes) const {
    RepairOptions options;
    options.cancel = cancel_;
    options.close_holes = close_holes;
    RepairReport report;
    try {
      repair(mesh_, options, &report);
    } catch (const InvalidSolid&) {
      // The report was filled so far; what stopped it is what the list says.
    }
    stop_if_cancelled();
    return report;
  }

  // A surface with holes is refused before it is looked at for crossings.
  void add_contacts_beside_holes() {
    for (const RepairChange& change : report_of(true).changes) {
      const bool crosses = change.kind == Change::divided_faces;
      if (!crosses && change.kind != Change::overlaps) continue;
      MeshDefect defect;
      defect.kind = Kind::contact;
      defect.text = std::to_string(change.count);
      if (crosses)
        defect.text += change.count == 1 ? " face is crossed or met by others"
                                         : " faces are crossed or met by others, the first";
      else
        defect.text += change.count == 1 ? " place where faces lie on each other"
                                         : " places where faces lie on each other, the first";
      defect.place = to_glm(change.where);
      if (change.face != no_element) defect.faces.push_back(change.face);
      add(std::move(defect));
    }
  }

  void add_hole(const Hole& hole) {
    MeshDefect defect;
    defect.kind = Kind::hole;
    defect.text =
        "Hole of " + std::to_string(hole.edges) + " edges, " + short_number(hole.length) + " long";
    defect.place = to_glm(hole.where);
    if (const auto piece = piece_at_.find(key(hole.where)); piece != piece_at_.end()) {
      auto e = std::ranges::lower_bound(edges_.borders, piece->second, {}, &OddEdge::piece);
      for (; e != edges_.borders.end() && e->piece == piece->second; ++e) append(defect.edges, *e);
    }
    add(std::move(defect));
  }

  static std::array<double, 3> key(const Vec3& p) { return {p.x, p.y, p.z}; }

  void look_at_edges() {
    edges_ = odd_edges(mesh_);
    std::ranges::stable_sort(edges_.borders, {}, &OddEdge::piece);
    for (const OddEdge& e : edges_.borders) piece_at_[key(e.from)] = piece_at_[key(e.to)] = e.piece;
  }

  void add_change(const RepairChange& change) {
    const std::optional<Words> words = words_for(change.kind);
    if (!words) return;
    MeshDefect defect;
    defect.kind = words->kind;
    defect.text =
        std::to_string(change.count) + " " + (change.count == 1 ? words->one : words->many);
    defect.place = to_glm(change.where);
    if (change.face != no_element) defect.faces.push_back(change.face);
    if (change.kind == Change::turned_faces)
      for (const OddEdge& e : edges_.contradictions) append(defect.edges, e);
    add(std::move(defect));
  }

  void add_refusal() {
    MeshDefect defect;
    const InvalidSolid::Reason reason = refusal_.reason();
    const bool turned =
        reason == InvalidSolid::Reason::inside_out || reason == InvalidSolid::Reason::inconsistent;
    defect.kind = turned ? Kind::orientation : Kind::other;
    defect.text = capitalised(refusal_.what());
    if (refusal_.face() < mesh_.face_sizes.size()) defect.faces.push_back(refusal_.face());
    if (drawable_ && !defect.faces.empty() && mesh_.face_sizes[refusal_.face()] > 0)
      defect.place = to_glm(mesh_.positions[mesh_.indices[first_corner_[refusal_.face()]]]);
    for (const OddEdge& e : edges_.contradictions) append(defect.edges, e);
    add(std::move(defect));
  }

  static void append(std::vector<glm::vec3>& ends, const OddEdge& edge) {
    ends.push_back(glm::vec3(to_glm(edge.from)));
    ends.push_back(glm::vec3(to_glm(edge.to)));
  }

  void add_surfaces() {
    std::vector<std::uint8_t> touches(mesh_.face_sizes.size(), 0);
    for (const MeshDefect& defect : found_.list)
      if (defect.kind == Kind::contact)
        for (const std::uint32_t f : defect.faces) touches[f] = 1;
    found_.sound = surface_of(touches, 0);
    stop_if_cancelled();
    found_.touching = surface_of(touches, 1);
    for (const OddEdge& e : edges_.borders) append(found_.borders, e);
    for (const OddEdge& e : edges_.contradictions) append(found_.contradictions, e);
    for (const Vec3& p : mesh_.positions) found_.bounds.add(to_glm(p));
  }

  std::shared_ptr<const SurfaceMesh> surface_of(const std::vector<std::uint8_t>& kinds,
                                                std::uint8_t kind) const {
    SurfacePart part;
    for (std::uint32_t f = 0; f < kinds.size(); ++f) {
      if (kinds[f] != kind || mesh_.face_sizes[f] < 3) continue;
      std::vector<std::uint32_t> loop;
      for (std::size_t i = 0; i < mesh_.face_sizes[f]; ++i) {
        loop.push_back(static_cast<std::uint32_t>(part.positions.size()));
        part.positions.push_back(mesh_.positions[mesh_.indices[first_corner_[f] + i]]);
      }
      part.faces.push_back({{std::move(loop)}, {0, f}});
    }
    return surface_mesh(part);
  }

  const PolygonMesh& mesh_;
  const InvalidSolid& refusal_;
  const std::atomic<bool>* cancel_;
  std::vector<std::size_t> first_corner_;
  bool drawable_ = false;
  OddEdges edges_;                                           // borders by piece
  std::map<std::array<double, 3>, std::uint32_t> piece_at_;  // of borders
  MeshDefects found_;
};

}  // namespace

const char* heading_of(MeshDefect::Kind kind) {
  switch (kind) {
    case Kind::contact:
      return "Crossings and overlaps";
    case Kind::hole:
      return "Holes";
    case Kind::orientation:
      return "Orientation";
    case Kind::degenerate:
      return "Degenerate faces";
    case Kind::other:
      break;
  }
  return "What was found";
}

MeshDefects find_defects(const PolygonMesh& mesh, const InvalidSolid& refusal,
                         const std::atomic<bool>* cancel) {
  return DefectFinder(mesh, refusal, cancel).run();
}

}  // namespace sectile::viewer
