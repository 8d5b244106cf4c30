#include "arrangement/solids.h"

#include <algorithm>

#include "arrangement/row_parts.h"
#include "boolean/cleanup/cleanup.h"
#include "import/brep_builder.h"
#include "parallel/parallel.h"
#include "search/id_map.h"
#include "sectile/errors.h"
#include "storage/geometry_loader.h"

namespace sectile::arrangement {
namespace {

class Builder {
 public:
  Builder(const SubFaces& faces, const Cells& cells, const Facets& facets, const Geometry& geometry,
          const Kernel& kernel, const CellsOfSolids& solids, std::uint32_t solid,
          const SolidBoundary& boundary, Merging merging, const Steering& steering)
      : faces_(faces),
        cells_(cells),
        facets_(facets),
        kernel_(kernel),
        solids_(solids),
        solid_(solid),
        boundary_(boundary),
        merging_(merging),
        steering_(steering),
        data_(std::make_shared<SolidData>()),
        copy_(geometry, data_->geometry(), corner_count()),
        parts_(row_parts(cells, solids, solid, boundary.rows)),
        made_part_(parts_.size() / 2, none),
        made_(corner_count(), faces.polygons.corners.size()) {}

  std::shared_ptr<SolidData> run() {
    steering_.step(0.8);
    add_faces();
    steering_.step(0.84);
    if (result_.face_count() == 0) return std::make_shared<SolidData>();
    pair_half_edges();
    steering_.step(0.86);
    Brep& brep = data_->brep();
    build_brep(result_, mate_, brep);
    steering_.step(0.9);
    for (const FaceId f : brep.faces()) {
      brep.plane[f] = plane_[f.value()];
      brep.source[f] = source_[f.value()];
    }
    find_seams();
    steering_.step(0.92);
    clean_up(brep, data_->geometry(), seams_);
    steering_.step(0.95);
    data_->cut();
    steering_.step(1.0);
    return std::move(data_);
  }

 private:
  std::size_t corner_count() const {
    std::size_t count = 0;
    for (const std::uint32_t f : boundary_.faces) count += faces_.polygons.face_corners(f).size();
    return count;
  }
  bool in(std::uint32_t cell) const { return solids_.solid[cell] == solid_; }
  /// Material lies where the normal points to.
  bool is_turned(std::uint32_t f) const { return in(cells_.before[f]); }

  void add_faces() {
    for (std::size_t i = 0; i < boundary_.faces.size(); ++i) {
      if (i % 4096 == 0) steering_.check();
      const std::uint32_t f = boundary_.faces[i];
      const bool turned = is_turned(f);
      const Polygons& from = faces_.polygons;
      for (std::uint32_t l = from.first_loop(f); l < from.face_end[f]; ++l) {
        const std::uint32_t begin = from.loop_begin(l), end = from.loop_end[l], size = end - begin;
        for (std::uint32_t k = 0; k < size; ++k) {
          // Turned, the half-edge from i to i + 1 leaves i + 1.
          const std::uint32_t leaves = turned ? begin + (size - k) % size : begin + k;
          const std::uint32_t old = turned ? begin + (size - k - 1) : leaves;
          made_[old] = static_cast<std::uint32_t>(result_.corners.size());
          if (is_in_row(old))
            add_parts(old, turned);
          else
            add_corner(from.corners[leaves], old);
        }
        result_.loop_end.push_back(static_cast<std::uint32_t>(result_.corners.size()));
      }
      choose_plane(f, turned);
    }
  }

  void add_corner(PointId point, std::uint32_t old) {
    result_.corners.push_back(copy_.point(point));
    old_.push_back(old);
  }

  bool is_in_row(std::uint32_t old) const { return !faces_.row.empty() && faces_.row[old] != none; }

  // Along the half-edge, which is turned or not.
  void add_parts(std::uint32_t old, bool turned) {
    const auto first = std::ranges::lower_bound(parts_, old, {}, &RowPart::corner),
               last = std::ranges::upper_bound(parts_, old, {}, &RowPart::corner);
    if (first == last) throw InternalError("an edge of the result has only one face");
    const bool along = first->forward != turned;
    for (auto part = first; part != last; ++part)
      if (part != first && part->from != std::prev(part)->to)
        throw InternalError("a part of an edge of the result has only one face");
    for (std::ptrdiff_t i = 0; i < last - first; ++i) {
      const RowPart& part = *(along ? first + i : last - 1 - i);
      const auto made = static_cast<std::uint32_t>(result_.corners.size());
      add_corner(along ? part.begin : part.end, old);
      std::uint32_t& other = made_part_[part.wedge];
      if (other == none)
        other = made;
      else
        wedges_.push_back({other, made});
    }
  }

  // The lowest of the faces that look outwards, if there is one.
  void choose_plane(std::uint32_t f, bool turned) {
    const auto cover = faces_.cover_of(f);
    std::uint32_t chosen = cover[0];
    bool back = turned == kernel_.same_direction(faces_.plane[f], facets_.plane[chosen]);
    for (const std::uint32_t g : cover) {
      if (turned == kernel_.same_direction(faces_.plane[f], facets_.plane[g])) continue;
      chosen = g;
      back = false;
      break;
    }
    plane_.push_back(back ? copy_.plane(facets_.plane[chosen], true)
                          : copy_.plane(facets_.plane[chosen]));
    source_.push_back(facets_.source[chosen]);
    result_.end_face(f);
  }

  void pair_half_edges() {
    mate_.assign(result_.corners.size(), none);
    for (std::uint32_t made = 0; made < old_.size(); ++made)
      if (const std::uint32_t mate = cells_.mate[old_[made]]; mate != none) {
        mate_[made] = made_.known(mate);
        if (mate_[made] == none)
          throw InternalError("one of two neighbouring parts is kept, the other is not");
      }
    for (const std::uint32_t fan : boundary_.fans) pair_wedges(cells_.of(cells_.fans[fan]));
    for (const auto& [a, b] : wedges_) {
      mate_[a] = b;
      mate_[b] = a;
    }
    for (const std::uint32_t m : mate_)
      if (m == none) throw InternalError("an edge of the result has only one face");
  }

  // Each pair bounds one wedge of material.
  void pair_wedges(std::span<const EdgeFan::Side> sides) {
    kept_.clear();
    for (const EdgeFan::Side& s : sides)
      if (made_.known(s.corner) != none) kept_.push_back(s);
    for (std::size_t i = 0; i < kept_.size(); ++i) {
      if (!in(cell_after(kept_[i]))) continue;
      const EdgeFan::Side& next = kept_[i + 1 < kept_.size() ? i + 1 : 0];
      if (!in(cell_before(next)))
        throw InternalError("the material around an edge does not alternate");
      const std::uint32_t a = made_.known(kept_[i].corner), b = made_.known(next.corner);
      mate_[a] = b;
      mate_[b] = a;
    }
  }
  std::uint32_t cell_after(const EdgeFan::Side& s) const {
    const std::uint32_t f = cells_.face_of[s.corner];
    return s.forward ? cells_.before[f] : cells_.behind[f];
  }
  std::uint32_t cell_before(const EdgeFan::Side& s) const {
    const std::uint32_t f = cells_.face_of[s.corner];
    return s.forward ? cells_.behind[f] : cells_.before[f];
  }

  // Edges between coplanar faces need a plane that pins them down. What division has made may go.
  void find_seams() {
    const Brep& brep = data_->brep();
    std::vector<std::uint32_t> corner_of(brep.edge_count(), none);
    std::vector<std::uint8_t> flat(brep.edge_count(), 0);
    // build_brep numbers edges by their first corner.
    std::uint32_t edge = 0;
    for (std::uint32_t c = 0; c < mate_.size(); ++c)
      if (c < mate_[c]) corner_of[edge++] = c;
    parallel::loop(parallel::Range<std::size_t>(0, flat.size(), 2048), [&](const auto& range) {
      for (std::size_t e = range.begin(); e < range.end(); ++e) {
        const std::uint32_t c = corner_of[e];
        flat[e] = kernel_.parallel(faces_.plane[face(c)], faces_.plane[face(mate_[c])]);
      }
    });
    for (std::size_t e = 0; e < flat.size(); ++e) {
      const std::uint32_t c = corner_of[e];
      if (flat[e]) pin(EdgeId(e), c);
      const bool divided =
          is_in_row(old_[c]) || faces_.divided[face(c)] || faces_.divided[face(mate_[c])];
      if (divided && may_go(c)) seams_.push_back(EdgeId(e));
    }
  }
  std::uint32_t face(std::uint32_t corner) const { return cells_.face_of[old_[corner]]; }

  bool may_go(std::uint32_t corner) const {
    return merging_ == Merging::all || cells_.mate[old_[corner]] != none;
  }

  void pin(EdgeId e, std::uint32_t corner) {
    Brep& brep = data_->brep();
    if (brep.edge_plane.empty()) brep.edge_plane.resize(brep.edge_count());
    PlaneId& plane = brep.edge_plane[e];
    for (const std::uint32_t c : {corner, mate_[corner]})
      if (faces_.across[old_[c]].valid() && !plane.valid() &&
          !kernel_.parallel(faces_.across[old_[c]], faces_.plane[face(c)]))
        plane = copy_.plane(faces_.across[old_[c]]);
    if (plane.valid()) return;
    Geometry& g = data_->geometry();
    const PointId from = result_.corners[corner], to = result_.corners[mate_[corner]];
    if (g.is_constructed(from) || g.is_constructed(to))
      throw InternalError("nothing pins down an edge between flat faces");
    plane = g.add_plane(
        PlaneDefinition::along_axis(from, to, kernel_.main_axis(faces_.plane[face(corner)])));
  }

  const SubFaces& faces_;
  const Cells& cells_;
  const Facets& facets_;
  const Kernel& kernel_;
  const CellsOfSolids& solids_;
  std::uint32_t solid_;
  const SolidBoundary& boundary_;
  Merging merging_;
  const Steering& steering_;
  std::shared_ptr<SolidData> data_;
  std::vector<EdgeId> seams_;
  GeometryLoader copy_;
  Polygons result_;
  std::vector<PlaneId> plane_;
  std::vector<FaceSource> source_;
  const std::vector<RowPart> parts_;
  std::vector<std::uint32_t> made_part_;  // per wedge of a row: the corner that was made first
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wedges_;  // of rows: corners of the result
  IdMap made_;  // corners of the sub-faces to those of the result, the first ones
  std::vector<std::uint32_t> old_;   // per corner of the result: the sub-faces'
  std::vector<std::uint32_t> mate_;  // per corner of the result
  std::vector<EdgeFan::Side> kept_;
};

}  // namespace

std::shared_ptr<SolidData> solid_of(const SubFaces& faces, const Cells& cells, const Facets& facets,
                                    const Geometry& geometry, const Kernel& kernel,
                                    const CellsOfSolids& solids, std::uint32_t solid,
                                    const SolidBoundary& boundary, Merging merging,
                                    const Steering& steering) {
  return Builder(faces, cells, facets, geometry, kernel, solids, solid, boundary, merging, steering)
      .run();
}

std::shared_ptr<SolidData> solid_of(const SubFaces& faces, const Cells& cells, const Facets& facets,
                                    const Geometry& geometry, const Kernel& kernel,
                                    const CellsOfSolids& marked, Merging merging,
                                    const Steering& steering) {
  return solid_of(faces, cells, facets, geometry, kernel, marked, 0, marked.boundaries(cells)[0],
                  merging, steering);
}

}  // namespace sectile::arrangement
