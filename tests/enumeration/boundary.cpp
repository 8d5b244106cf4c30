#include "boundary.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <stdexcept>

namespace sectile::test {
namespace {

// Classes of numbers that were joined.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }
  int find(int i) const {
    while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
    return i;
  }
  void join(int i, int j) { parent_[static_cast<std::size_t>(find(i))] = find(j); }
  /// The class of each number, numbered from 0; returns how many classes there are.
  int number(std::vector<int>& classes) const {
    std::map<int, int> known;
    for (std::size_t i = 0; i < parent_.size(); ++i)
      classes.push_back(known.try_emplace(find(static_cast<int>(i)), static_cast<int>(known.size()))
                            .first->second);
    return static_cast<int>(known.size());
  }

 private:
  std::vector<int> parent_;
};

// An edge of a cell, as it runs in one of the two sides that it bounds.
struct CellEdge {
  int cell, side, from, to;
};

// The same edge in the other side of the same cell, where it runs the other way.
CellEdge across(const Complex& complex, const CellEdge& e) {
  const auto& sides = complex.cell(e.cell).sides;
  for (int s = 0; s < static_cast<int>(sides.size()); ++s) {
    const auto& corners = sides[static_cast<std::size_t>(s)].corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (corners[i] == e.to && corners[(i + 1) % corners.size()] == e.from)
        return {e.cell, s, e.to, e.from};
  }
  throw std::logic_error("a cell is not closed");
}

// Turns through the material around the edge until it ends.
CellEdge other_end_of_wedge(const Complex& complex, Mask mask, CellEdge e) {
  while (true) {
    e = across(complex, e);
    const Complex::Side& side = complex.side(e.cell, e.side);
    if (!Complex::has(mask, side.neighbour)) return e;
    e = {side.neighbour, side.twin, e.to, e.from};
  }
}

}  // namespace

Boundary::Boundary(const Complex& complex, Mask mask) : complex_(complex) {
  std::vector<std::pair<int, int>> sides;
  complex.for_each_exposed(mask, [&](int c, int s) {
    sides.emplace_back(c, s);
    const Complex::Side& side = complex.side(c, s);
    faces_.push_back({&side, static_cast<int>(face_of_.size())});
    face_of_.insert(face_of_.end(), side.corners.size(), static_cast<int>(faces_.size()) - 1);
  });
  find_partners(mask, sides);
  count();
}

int Boundary::next(int h) const {
  const Face& face = faces_[static_cast<std::size_t>(face_of_[static_cast<std::size_t>(h)])];
  return face.first + (h - face.first + 1) % static_cast<int>(face.side->corners.size());
}

int Boundary::point_of(int h) const {
  const Face& face = faces_[static_cast<std::size_t>(face_of_[static_cast<std::size_t>(h)])];
  return face.side->corners[static_cast<std::size_t>(h - face.first)];
}

void Boundary::find_partners(Mask mask, const std::vector<std::pair<int, int>>& sides) {
  std::map<std::array<int, 4>, int> number;
  const auto edge = [&](int h) -> CellEdge {
    const auto [c, s] = sides[static_cast<std::size_t>(face_of_[static_cast<std::size_t>(h)])];
    return {c, s, point_of(h), point_of(next(h))};
  };
  const int count = static_cast<int>(face_of_.size());
  for (int h = 0; h < count; ++h) {
    const CellEdge e = edge(h);
    number[{e.cell, e.side, e.from, e.to}] = h;
  }
  for (int h = 0; h < count; ++h) {
    const CellEdge e = other_end_of_wedge(complex_, mask, edge(h));
    partner_.push_back(number.at({e.cell, e.side, e.from, e.to}));
  }
}

void Boundary::count() {
  Classes corners(face_of_.size()), shells(faces_.size());
  for (std::size_t i = 0; i < partner_.size(); ++i) {
    const int h = static_cast<int>(i), p = partner_[i];
    corners.join(h, next(p));
    shells.join(face_of_[i], face_of_[static_cast<std::size_t>(p)]);
  }
  vertex_count_ = corners.number(vertex_);
  std::vector<int> shell_of;
  shell_count_ = shells.number(shell_of);
  const int edges = static_cast<int>(face_of_.size()) / 2, faces = static_cast<int>(faces_.size());
  genus_ = shell_count_ - (vertex_count_ - edges + faces) / 2;
}

bool Boundary::trace_outline(const std::vector<int>& group, int g,
                             std::vector<int>& outline) const {
  const auto group_of = [&](int h) {
    return group[static_cast<std::size_t>(face_of_[static_cast<std::size_t>(h)])];
  };
  const auto is_outline = [&](int h) {
    return group_of(h) == g && group_of(partner_[static_cast<std::size_t>(h)]) != g;
  };
  int start = -1, length = 0;
  for (int h = 0; h < static_cast<int>(face_of_.size()); ++h)
    if (is_outline(h)) {
      start = h;
      ++length;
    }
  std::vector<int> points;
  for (int h = start; outline.empty() || h != start;) {
    outline.push_back(h);
    points.push_back(point_of(h));
    for (h = next(h); !is_outline(h); h = next(partner_[static_cast<std::size_t>(h)])) continue;
  }
  std::sort(points.begin(), points.end());
  return static_cast<int>(outline.size()) == length &&
         std::adjacent_find(points.begin(), points.end()) == points.end();
}

// Polygons as half-edges whose starts are the corners.
std::vector<std::vector<int>> Boundary::merged_polygons() const {
  Classes coplanar(faces_.size());
  for (std::size_t i = 0; i < partner_.size(); ++i) {
    const int f = face_of_[i], g = face_of_[static_cast<std::size_t>(partner_[i])];
    if (faces_[static_cast<std::size_t>(f)].side->normal ==
        faces_[static_cast<std::size_t>(g)].side->normal)
      coplanar.join(f, g);
  }
  std::vector<int> group;
  const int groups = coplanar.number(group);
  std::vector<std::vector<int>> polygons;
  for (int g = 0; g < groups; ++g) {
    std::vector<int> outline;
    if (trace_outline(group, g, outline)) {
      polygons.push_back(outline);
      continue;
    }
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (group[f] == g) {
        polygons.emplace_back(faces_[f].side->corners.size());
        std::iota(polygons.back().begin(), polygons.back().end(), faces_[f].first);
      }
  }
  return polygons;
}

PolygonMesh Boundary::mesh(Meshing how) const {
  PolygonMesh mesh;
  std::map<int, std::uint32_t> known;
  int serial = 0;
  const auto add_corner = [&](int h) {
    const int vertex = vertex_[static_cast<std::size_t>(h)];
    const int key = how == Meshing::own                                ? serial++
                    : how == Meshing::wedges || how == Meshing::merged ? vertex
                                                                       : point_of(h);
    const auto [entry, first] =
        known.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
    if (first) {
      const auto& p = complex_.point(point_of(h));
      mesh.positions.push_back({double(p[0]), double(p[1]), double(p[2])});
    }
    mesh.indices.push_back(entry->second);
  };
  const auto add_polygon = [&](const std::vector<int>& corners) {
    for (const int h : corners) add_corner(h);
    mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  };
  if (how == Meshing::merged) {
    for (const auto& polygon : merged_polygons()) add_polygon(polygon);
    return mesh;
  }
  for (const Face& face : faces_) {
    std::vector<int> corners(face.side->corners.size());
    std::iota(corners.begin(), corners.end(), face.first);
    if (how == Meshing::shared || how == Meshing::wedges) {
      add_polygon(corners);
    } else {
      for (std::size_t i = 2; i < corners.size(); ++i)
        add_polygon({corners[0], corners[i - 1], corners[i]});
    }
  }
  return mesh;
}

}  // namespace sectile::test
