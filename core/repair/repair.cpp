#include "sectile/repair.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "arrangement/solids.h"
#include "import/diagnosis.h"
#include "import/flat_edges.h"
#include "repair/borders.h"
#include "repair/large_mesh.h"
#include "repair/shells_alone.h"
#include "repair/stitching.h"

namespace sectile {
namespace {

using arrangement::Cells;
using arrangement::Counting;
using arrangement::Facets;
using arrangement::SubFaces;
using Kind = RepairChange::Kind;

class Repairer {
 public:
  Repairer(const PolygonMesh& mesh, const RepairOptions& options, RepairReport& report)
      : mesh_(mesh),
        options_(options),
        report_(report),
        steering_{options.cancel, rising(options.progress)},
        balance_(options.rule == Rule::odd ? Balance::parity : Balance::oriented) {}

  Solid run() {
    Solid solid = repaired();
    steering_.step(1);
    return solid;
  }

 private:
  Solid repaired() {
    report_ = {};
    origin_ = new_origin();
    const LargeMesh large = resolve_large_mesh(
        {mesh_.positions, {}, mesh_.face_sizes, mesh_.indices}, options_.rule, origin_, steering_);
    if (large.united) return read_straight(large);
    read(mesh_);
    if (options_.stitch > 0) stitch_borders();
    steering_.step(0.06);
    std::vector<std::uint32_t> mate = match_plain_edges(polygons_, *kernel_);
    if (mate.empty()) close();
    steering_.step(0.1);
    const std::size_t count = polygons_.face_count();
    const Vec3 where = count > 0 ? corner(0) : Vec3();
    if (find_planes() || mate.empty()) mate = match_plain_edges(polygons_, *kernel_);
    if (polygons_.face_count() == 0) {
      note(Kind::removed_faces, count, where, no_element);  // without those told of already
      return Solid();
    }
    steering_.step(0.15);
    if (large.is_tangled) return arranged();
    if (const auto simple =
            shells_alone(polygons_, mate, geometry_, *kernel_, options_.rule, origin_, steering_)) {
      note_faces(Kind::divided_faces, simple->divided);
      if (simple->overlaps > 0)
        note(Kind::overlaps, simple->overlaps, corner(simple->first_overlap),
             polygons_.source[simple->first_overlap]);
      note_faces(Kind::removed_faces, simple->removed);
      return Solid(simple->data);
    }
    return arranged();
  }

  // What is done again in another way is not told again.
  static std::function<void(double)> rising(const std::function<void(double)>& progress) {
    if (!progress) return {};
    return [&progress, told = 0.0](double done) mutable {
      if (done < told) return;
      told = done;
      progress(done);
    };
  }

  Solid read_straight(const LargeMesh& large) {
    note_united(large.input_vertex);
    note_input_faces(Kind::divided_faces, large.united->divided, large.source);
    if (const std::size_t count = large.united->overlaps; count > 0) {
      const std::uint32_t first = large.source[large.united->first_overlap];
      note(Kind::overlaps, count, mesh_.positions[mesh_.indices[3 * std::size_t(first)]], first);
    }
    note_input_faces(Kind::removed_faces, large.united->removed, large.source);
    return Solid(large.united->data);
  }

  void note_input_faces(Kind kind, const std::vector<std::uint32_t>& faces,
                        const std::vector<std::uint32_t>& source) {
    if (faces.empty()) return;
    std::uint32_t first = no_element;
    for (const std::uint32_t f : faces) first = std::min(first, source[f]);
    note(kind, faces.size(), mesh_.positions[mesh_.indices[3 * std::size_t(first)]], first);
  }

  void note(Kind kind, std::size_t count, const Vec3& where, std::uint32_t face) {
    if (count > 0) report_.changes.push_back({kind, count, where, face});
  }
  const Vec3& position(PointId p) const { return geometry_.position(p); }
  const Vec3& corner(std::size_t f) const { return position(polygons_.face_corners(f)[0]); }

  void read(const PolygonMesh& mesh) {
    geometry_ = Geometry();
    input_vertex_.clear();
    polygons_ = read_polygons({mesh.positions, {}, mesh.face_sizes, mesh.indices}, geometry_,
                              input_vertex_);
    kernel_ = std::make_unique<Kernel>(geometry_);
    note_united(input_vertex_);
    remove_flat_faces(polygons_, *kernel_);
    note_removed(mesh);
    steering_.step(0.05);
  }

  // Nothing is said where all are different.
  void note_united(const std::vector<std::uint32_t>& input_vertex) {
    if (input_vertex.empty()) return;
    const std::size_t united = mesh_.positions.size() - input_vertex.size();
    if (united == 0) return;
    // The first one that is not the first at its place.
    std::uint32_t i = 0;
    while (i < input_vertex.size() && input_vertex[i] == i) ++i;
    note(Kind::united_vertices, united, mesh_.positions[i], no_element);
  }

  void note_removed(const PolygonMesh& mesh) {
    const std::size_t count = mesh.face_sizes.size() - polygons_.face_count();
    if (count == 0) return;
    std::uint32_t first = 0;
    while (first < polygons_.face_count() && polygons_.source[first] == first) ++first;
    std::size_t c = 0;
    for (std::uint32_t f = 0; f < first; ++f) c += mesh.face_sizes[f];
    note(Kind::removed_flat, count,
         mesh.face_sizes[first] > 0 ? mesh.positions[mesh.indices[c]] : Vec3(), first);
  }

  void stitch_borders() {
    const std::vector<std::uint32_t> open = open_corners(polygons_, Balance::parity);
    if (open.empty()) return;
    std::vector<PointId> points;
    std::vector<std::pair<PointId, PointId>> edges;
    for (const std::uint32_t c : open) {
      const std::size_t l = static_cast<std::size_t>(
          std::upper_bound(polygons_.loop_end.begin(), polygons_.loop_end.end(), c) -
          polygons_.loop_end.begin());
      const std::uint32_t next = c + 1 < polygons_.loop_end[l] ? c + 1 : polygons_.loop_begin(l);
      edges.push_back({polygons_.corners[c], polygons_.corners[next]});
      points.insert(points.end(), {edges.back().first, edges.back().second});
    }
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    const auto number = [&](PointId p) {
      return static_cast<std::uint32_t>(std::lower_bound(points.begin(), points.end(), p) -
                                        points.begin());
    };
    std::vector<Vec3> positions;
    for (const PointId p : points) positions.push_back(position(p));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours;
    for (const auto& [p, q] : edges) neighbours.push_back({number(p), number(q)});
    const Moves moves = stitch(positions, neighbours, options_.stitch);
    if (moves.empty()) return;
    PolygonMesh stitched = mesh_;
    for (Vec3& p : stitched.positions) p = {p.x + 0.0, p.y + 0.0, p.z + 0.0};
    apply(moves, stitched.positions);
    report_.changes.clear();
    read(stitched);
    note(Kind::stitched_vertices, moves.size(), moves.front().first, no_element);
  }

  // Makes a surface without borders of the polygons.
  void close() {
    std::vector<std::uint32_t> open = open_corners(polygons_, balance_);
    if (open.empty()) return;
    remove_copies();
    if (balance_ == Balance::oriented) orient_faces();
    open = open_corners(polygons_, balance_);
    if (open.empty()) return;
    const std::size_t corners = polygons_.corners.size();
    if (divide_open_edges(polygons_, *kernel_, open))
      note(Kind::divided_edges, polygons_.corners.size() - corners, Vec3(), no_element);
    if (balance_ == Balance::oriented) orient_faces();
    const std::vector<BorderLoop> loops = border_loops(polygons_, balance_);
    if (loops.empty()) return;
    if (open_corners(polygons_, Balance::parity).empty()) refuse_to_orient(loops.front());
    for (const BorderLoop& loop : loops) note_hole(loop);
    if (!options_.close_holes) refuse();
    const auto next = static_cast<std::uint32_t>(mesh_.face_sizes.size());
    for (std::size_t i = 0; i < loops.size(); ++i) {
      if (loops[i].corners.size() < 3) continue;  // to and fro
      polygons_.add_loop(loops[i].corners);
      polygons_.end_face(next + static_cast<std::uint32_t>(i));
    }
    note(Kind::closed_holes, loops.size(), report_.holes.front().where, report_.holes.front().face);
    remove_flat_faces(polygons_, *kernel_);
  }

  void remove_copies() {
    const Polygons before = polygons_;
    const std::vector<std::uint32_t> removed = sectile::remove_copies(polygons_, balance_);
    if (removed.empty()) return;
    note(Kind::removed_copies, removed.size(), position(before.face_corners(removed[0])[0]),
         before.source[removed[0]]);
  }

  void orient_faces() {
    const std::vector<std::uint32_t> turned = orient(polygons_);
    if (turned.empty()) return;
    note(Kind::turned_faces, turned.size(), corner(turned.front()),
         polygons_.source[turned.front()]);
  }

  void note_hole(const BorderLoop& loop) {
    Hole hole;
    hole.edges = loop.corners.size();
    for (std::size_t i = 0; i < loop.corners.size(); ++i) {
      const Vec3 &p = position(loop.corners[i]),
                 &q = position(loop.corners[i + 1 < loop.corners.size() ? i + 1 : 0]);
      hole.length += std::hypot(q.x - p.x, q.y - p.y, q.z - p.z);
    }
    hole.where = position(loop.corners[0]);
    hole.face = polygons_.source[loop.face];
    report_.holes.push_back(hole);
  }

  [[noreturn]] void refuse_to_orient(const BorderLoop& loop) const {
    throw InvalidSolid(InvalidSolid::Reason::inconsistent,
                       "the surface is closed, but its faces cannot be turned so that all agree "
                       "with their neighbours, among them at " +
                           in_words(position(loop.corners[0])) + "; use the rule odd",
                       polygons_.source[loop.face]);
  }

  [[noreturn]] void refuse() const {
    const std::size_t count = report_.holes.size();
    std::string text =
        "the surface has " + std::to_string(count) + (count == 1 ? " hole" : " holes");
    constexpr std::size_t most = 10;
    for (std::size_t i = 0; i < std::min(count, most); ++i) {
      const Hole& hole = report_.holes[i];
      text += (i == 0 ? ": " : ", ") + std::to_string(hole.edges) + " edges of length " +
              in_words(hole.length) + " at " + in_words(hole.where);
    }
    if (count > most) text += ", and so on";
    throw InvalidSolid(InvalidSolid::Reason::open, text + "; close them", report_.holes[0].face);
  }

  // True if polygons were split.
  bool find_planes() {
    const std::size_t before = polygons_.face_count();
    find_face_planes(polygons_, geometry_, *kernel_, CrossingFaces::split);
    if (polygons_.face_count() == before) return false;
    std::vector<std::uint32_t> pieces(mesh_.face_sizes.size() + report_.holes.size(), 0);
    for (const std::uint32_t source : polygons_.source) ++pieces[source];
    std::size_t count = 0;
    std::uint32_t first = no_element;
    for (std::uint32_t f = 0; f < mesh_.face_sizes.size(); ++f)
      if (pieces[f] > 1) {
        ++count;
        first = std::min(first, f);
      }
    if (count == 0) return true;
    const auto at = std::find(polygons_.source.begin(), polygons_.source.end(), first);
    note(Kind::split_polygons, count,
         corner(static_cast<std::size_t>(at - polygons_.source.begin())), first);
    return true;
  }

  Facets facets() {
    Facets facets;
    const std::size_t count = polygons_.face_count();
    facets.plane.resize(count);
    facets.source.resize(count);
    facets.operand.assign(count, 0);
    for (std::size_t f = 0; f < count; ++f) {
      facets.plane[f] = PlaneId(f);
      facets.source[f] = {origin_, polygons_.source[f]};
    }
    facets.polygons = std::move(polygons_);
    facets.link();
    return facets;
  }

  Solid arranged() {
    const Counting counting = options_.rule == Rule::odd ? Counting::parity : Counting::oriented;
    const Facets all = facets();
    const arrangement::FacetTree tree(all, *kernel_);
    const SubFaces faces = arrangement::arrange(all, tree, counting, arrangement::Crowds::in_rows,
                                                geometry_, *kernel_, steering_);
    const Cells cells =
        arrangement::find_cells(faces, all, tree, counting,
                                options_.rule == Rule::positive ? arrangement::InsideOut::turn
                                                                : arrangement::InsideOut::keep,
                                *kernel_, steering_);
    steering_.step(0.8);
    arrangement::CellsOfSolids material{{}, 1};
    for (const arrangement::Winding& winding : cells.winding) {
      const std::int32_t w = winding.empty() ? 0 : winding[0].second;
      const bool is_material = options_.rule == Rule::positive ? w >= 1 : w != 0;
      material.solid.push_back(is_material ? 0 : arrangement::none);
    }
    note_arrangement(all, faces, cells, material);
    auto data = arrangement::solid_of(faces, cells, all, geometry_, *kernel_, material,
                                      arrangement::Merging::all, steering_);
    if (!data->empty()) data->origin = origin_;
    return Solid(std::move(data));
  }

  void note_faces(Kind kind, const std::vector<std::uint32_t>& faces) {
    if (faces.empty()) return;
    const std::uint32_t source = polygons_.source[faces.front()];
    note(kind, faces.size(), corner(faces.front()),
         source < mesh_.face_sizes.size() ? source : no_element);
  }

  void note_face(Kind kind, std::size_t count, const Facets& all, std::uint32_t f) {
    if (count == 0) return;
    const std::uint32_t source = all.source[f].face;
    note(kind, count, position(all.from(all.begin(f))),
         source < mesh_.face_sizes.size() ? source : no_element);
  }

  void note_arrangement(const Facets& all, const SubFaces& faces, const Cells& cells,
                        const arrangement::CellsOfSolids& material) {
    note_face(Kind::divided_faces, faces.divided_faces, all, faces.first_divided);
    note_face(Kind::overlaps, faces.overlaps, all, faces.first_overlap);
    if (!cells.turned.empty())
      note_face(Kind::turned_parts, cells.turned.size(), all,
                *std::min_element(cells.turned.begin(), cells.turned.end()));
    std::vector<std::uint8_t> used(all.face_count(), 0);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
      if (material.solid[cells.before[f]] != material.solid[cells.behind[f]])
        for (const std::uint32_t g : faces.cover_of(f)) used[g] = 1;
    const auto first = std::find(used.begin(), used.end(), 0);
    if (first != used.end())
      note_face(Kind::removed_faces,
                static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)), all,
                static_cast<std::uint32_t>(first - used.begin()));
  }

  const PolygonMesh& mesh_;
  const RepairOptions& options_;
  RepairReport& report_;
  arrangement::Steering steering_;
  Balance balance_;
  Geometry geometry_;
  std::vector<std::uint32_t> input_vertex_;
  std::unique_ptr<Kernel> kernel_;
  Polygons polygons_;
  std::uint32_t origin_ = 0;
};

}  // namespace

Solid repair(const PolygonMesh& mesh, const RepairOptions& options, RepairReport* report) {
  RepairReport unread;
  return Repairer(mesh, options, report ? *report : unread).run();
}

}  // namespace sectile
