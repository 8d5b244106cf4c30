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
  Kernel kernel(geometry_);
  find_lines(kernel);
  if (lines_.count() > 1) find_crossings(kernel);
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

void CrowdedLines::find_crossings(Kernel& kernel) {
  std::vector<PlanesOfLine> planes(lines_.count());
  for (const Face& face : faces_) {
    if (face.line == none || planes[face.line].second.valid() || !has_edge_on_line(face)) continue;
    auto& [first, second] = planes[face.line];
    const PlaneId plane = load_plane(face);
    kernel.refresh();
    if (!first.valid())
      first = plane;
    else if (!kernel.parallel(first, plane))
      second = plane;
  }
  crossings_ = line_crossings(kernel, lines_, planes);
}

bool CrowdedLines::has_edge_on_line(const Face& face) const {
  return std::ranges::any_of(sides(face), [&](const Side& side) {
    return is_on(side.from, face.line) && is_on(side.to, face.line);
  });
}

PlaneId CrowdedLines::load_plane(const Face& face) {
  constexpr std::size_t few = 8;
  const Block& of = block(face);
  return GeometryLoader(of.geometry(), geometry_, few).plane(of.brep().plane[face.face]);
}

bool CrowdedLines::is_on(PointId p, std::uint32_t line) const {
  return std::ranges::any_of(lines_.of_point(p.value()),
                             [&](const SpineLines::On& on) { return on.line == line; });
}

FacePairs CrowdedLines::pairs() {
  FacePairs pairs;
  FacesAtCrossings at_crossings(crossings_, lines_.count());
  add_pairs_elsewhere(at_crossings, pairs);
  std::vector<PerOperand<std::vector<std::uint32_t>>> at(lines_.count());
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    if (faces_[f].line != none) at[faces_[f].line][faces_[f].solid].push_back(f);
  for (std::uint32_t line = 0; line < at.size(); ++line) add_pairs_along(line, at[line], pairs);
  for (std::uint32_t c = 0; c < crossings_.size(); ++c)
    for (const unsigned k : {0u, 1u}) add_pairs_at(crossings_[c], at_crossings.at(c), k, pairs);
  return pairs;
}

// Of faces that are not both at one line, and not both at a crossing. Adds those at crossings.
void CrowdedLines::add_pairs_elsewhere(FacesAtCrossings& at_crossings, FacePairs& pairs) {
  PerOperand<std::vector<Box>> boxes;
  PerOperand<std::vector<std::uint32_t>> groups;
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const Face& face = faces_[f];
    const Box box = face_box(block(face).brep(), block(face).geometry(), face.face);
    boxes[face.solid].push_back(box);
    groups[face.solid].push_back(
        face.line == none ? BoxTree::no_group : at_crossings.add(face.solid, f, face.line, box));
  }
  const auto first_of_b = static_cast<std::uint32_t>(boxes[Operand::a].size());
  BoxTree::overlaps(
      BoxTree(boxes[Operand::a], groups[Operand::a]),
      BoxTree(boxes[Operand::b], groups[Operand::b]),
      [&](std::uint32_t f, std::uint32_t g) { add_unless_apart(f, first_of_b + g, pairs); },
      [&](std::uint32_t group, std::uint32_t other) {
        return at_crossings.are_at_one_place(group, other);
      });
}

// Of faces of A at one line, and of B at the other one.
void CrowdedLines::add_pairs_at(const LineCrossing& crossing,
                                const FacesAtCrossings::OfLines& faces, unsigned line_of_a,
                                FacePairs& pairs) {
  const unsigned line_of_b = 1 - line_of_a;
  const std::vector<std::uint32_t>&of_a = faces[line_of_a][Operand::a],
        &of_b = faces[line_of_b][Operand::b];
  if (of_a.empty() || of_b.empty()) return;
  BoxTree::overlaps(
      BoxTree(boxes_at(crossing, line_of_a, of_a)), BoxTree(boxes_at(crossing, line_of_b, of_b)),
      [&](std::uint32_t i, std::uint32_t j) { add_unless_apart(of_a[i], of_b[j], pairs); });
}

std::vector<Box> CrowdedLines::boxes_at(const LineCrossing& crossing, unsigned own,
                                        std::span<const std::uint32_t> faces) const {
  std::vector<Box> boxes;
  for (const std::uint32_t f : faces) {
    LeavingCrossing leaving(lines_, crossing, own);
    for (const Side& side : sides(faces_[f]))
      leaving.add_corner(at(side.from),
                         {is_on(side.from, crossing.line[0]), is_on(side.from, crossing.line[1])});
    boxes.push_back(leaving.box());
  }
  return boxes;
}

void CrowdedLines::add_unless_apart(std::uint32_t f, std::uint32_t g, FacePairs& pairs) {
  if (!are_apart(f, g)) pairs.push_back({in_solid(f), in_solid(g)});
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
