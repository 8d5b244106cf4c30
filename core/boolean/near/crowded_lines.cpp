#include "boolean/near/crowded_lines.h"

#include <algorithm>
#include <tuple>

#include "boolean/collect.h"
#include "search/face_tree.h"
#include "storage/geometry_loader.h"

namespace sectile {
namespace {

auto coordinates(const Vec3& p) {
  return std::tie(p.x, p.y, p.z);
}

}  // namespace

CrowdedLines::CrowdedLines(const SolidData& a, const SolidData& b,
                           const PerOperand<std::span<const std::uint32_t>>& slots)
    : data_{&a, &b} {
  for (const Operand s : both_operands) {
    for (const std::uint32_t slot : slots[s]) add_faces(s, slot);
  }
  find_lines(Kernel(geometry_));
}

void CrowdedLines::add_faces(Operand s, std::uint32_t slot) {
  const Block& block = *data_[s]->slot(slot).block;
  const Brep& brep = block.brep();
  GeometryLoader loader(block.geometry(), geometry_, brep.vertex_count());
  for (std::size_t f = 0; f < block.face_count(); ++f) {
    const auto first = static_cast<std::uint32_t>(sides_.size());
    for_each_in_face(brep, FaceId(f), [&](HalfEdgeId h) {
      sides_.push_back(
          {h, loader.point(brep.point_of(brep.from(h))), loader.point(brep.point_of(brep.to(h)))});
    });
    faces_.push_back({s, slot, FaceId(f), first, static_cast<std::uint32_t>(sides_.size())});
  }
}

void CrowdedLines::find_lines(const Kernel& kernel) {
  std::vector<PointId> points;
  std::vector<PointPair> edges;
  for (const PointId p : geometry_.positions.ids()) points.push_back(p);
  for (const Side& side : sides_)
    edges.push_back(PointPair::between(side.from.value(), side.to.value()));
  lines_ = SpineLines(kernel, points, crowded_lines(kernel, points, edges, many_beside));
  if (empty()) return;
  for (Face& face : faces_)
    face.line = lines_.line_of_most([&](const auto& visit) {
      for (const Side& side : sides(face)) visit(side.from);
    });
}

bool CrowdedLines::is_on(PointId p, std::uint32_t line) const {
  return std::ranges::any_of(lines_.of_point(p.value()),
                             [&](const SpineLines::On& on) { return on.line == line; });
}

FacePairs CrowdedLines::pairs() {
  FacePairs pairs;
  add_pairs_off_lines(pairs);
  std::vector<PerOperand<std::vector<std::uint32_t>>> at(lines_.count());
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].line != none) at[faces_[f].line][faces_[f].solid].push_back(f);
  for (std::uint32_t line = 0; line < at.size(); ++line) add_pairs_along(line, at[line], pairs);
  return pairs;
}

// Of faces that are not both at one line.
void CrowdedLines::add_pairs_off_lines(FacePairs& pairs) {
  PerOperand<std::vector<Box>> boxes;
  PerOperand<std::vector<std::uint32_t>> lines;
  for (const Face& f : faces_) {
    boxes[f.solid].push_back(face_box(block(f).brep(), block(f).geometry(), f.face));
    lines[f.solid].push_back(f.line);
  }
  const auto first_of_b = static_cast<std::uint32_t>(boxes[Operand::a].size());
  BoxTree::overlaps(
      BoxTree(boxes[Operand::a], lines[Operand::a]), BoxTree(boxes[Operand::b], lines[Operand::b]),
      [&](std::uint32_t f, std::uint32_t g) {
        if (!are_apart(f, first_of_b + g)) pairs.push_back({in_solid(f), in_solid(first_of_b + g)});
      },
      [](std::uint32_t line, std::uint32_t other) { return line == other; });
}

bool CrowdedLines::are_apart(std::uint32_t f, std::uint32_t g) {
  if (hulls_.empty()) hulls_.resize(faces_.size());
  const Hull& of_f = hull(f);
  return apart(of_f, hull(g));
}

const Hull& CrowdedLines::hull(std::uint32_t face) {
  const Face& f = faces_[face];
  if (!hulls_[face]) hulls_[face] = face_hull(block(f).brep(), block(f).geometry(), f.face);
  return *hulls_[face];
}

// Of faces that leave the line in a common direction.
void CrowdedLines::add_pairs_along(std::uint32_t line,
                                   const PerOperand<std::vector<std::uint32_t>>& faces,
                                   FacePairs& pairs) const {
  PerOperand<std::vector<Box>> boxes;
  std::vector<Vec3> on_line, beside;
  for (const Operand s : both_operands)
    for (const std::uint32_t f : faces[s]) {
      on_line.clear();
      beside.clear();
      sort_corners(line, f, on_line, beside);
      boxes[s].push_back(lines_[line].box(on_line, beside));
    }
  BoxTree::overlaps(
      BoxTree(boxes[Operand::a]), BoxTree(boxes[Operand::b]),
      [&](std::uint32_t i, std::uint32_t j) {
        pairs.push_back({in_solid(faces[Operand::a][i]), in_solid(faces[Operand::b][j])});
      });
}

void CrowdedLines::sort_corners(std::uint32_t line, std::uint32_t face, std::vector<Vec3>& on_line,
                                std::vector<Vec3>& beside) const {
  for (const Side& side : sides(faces_[face]))
    (is_on(side.from, line) ? on_line : beside).push_back(at(side.from));
}

PerOperand<std::vector<FaceId>> CrowdedLines::faces() const {
  PerOperand<std::vector<FaceId>> faces;
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].line != none) faces[faces_[f].solid].push_back(in_solid(f));
  return faces;
}

void CrowdedLines::mark(Workspace& w) const {
  for (std::uint32_t line = 0; line < lines_.count(); ++line) {
    const auto [from, to] = lines_.extent(line);
    w.crowded_lines.push_back({load_point(geometry_, PointId(from), w.geometry),
                               load_point(geometry_, PointId(to), w.geometry)});
  }
  w.kernel->refresh();
  mark_vertices(w);
}

void CrowdedLines::mark_vertices(Workspace& w) const {
  struct Marked {
    Vec3 place;
    std::uint32_t line;
  };
  std::vector<Marked> marked;
  for (const SpineLines::On& on : lines_.points())
    marked.push_back({at(PointId(on.point)), on.line});
  const auto place = [](const Marked& m) { return coordinates(m.place); };
  std::ranges::sort(marked, {}, place);
  for (Patch& patch : w.patch)
    for (const VertexId v : patch.brep.vertices()) {
      const Vec3& position = w.geometry.position(patch.brep.point_of(v));
      const auto first = std::ranges::lower_bound(marked, coordinates(position), {}, place);
      const auto last = std::ranges::upper_bound(marked, coordinates(position), {}, place);
      const bool on_one =
          std::all_of(first, last, [&](const Marked& m) { return m.line == first->line; });
      patch.on_crowded_line.add(first == last ? 0 : on_one ? 1 + first->line : Patch::several);
    }
}

}  // namespace sectile
