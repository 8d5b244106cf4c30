#include "arrangement/sub_faces.h"

#include <algorithm>
#include <map>

#include "arrangement/plane_regions.h"
#include "arrangement/self_touching.h"
#include "boolean/collect.h"
#include "numbers/disjoint_sets.h"
#include "parallel/parallel.h"

namespace sectile::arrangement {
namespace {

// Faces that overlap in one plane, and each face that others or it itself meet, in groups.
class Groups {
 public:
  Groups(const Facets& facets, const std::vector<FacePair>& pairs, const Traces& traces,
         const RowLines& rows, const Kernel& kernel,
         const std::vector<std::uint8_t>& touches_itself)
      : facets_(facets), traces_(traces), rows_(rows), kernel_(kernel), sets_(facets.face_count()) {
    std::vector<std::uint8_t> overlaps(sets_.size(), 0);
    for (const FacePair& pair : pairs)
      if (pair.how == Meeting::overlapping) {
        overlaps[pair.f] = overlaps[pair.g] = 1;
        sets_.unite(pair.f, pair.g);
      }
    std::vector<std::uint32_t> number(sets_.size(), none);
    divided.assign(sets_.size(), 0);
    for (std::uint32_t f = 0; f < sets_.size(); ++f) {
      if (!overlaps[f] && !touches_itself[f] && !is_met(f)) continue;
      divided[f] = 1;
      std::uint32_t& n = number[sets_.first(f)];
      if (n == none) {
        n = static_cast<std::uint32_t>(groups.size());
        groups.emplace_back();
      }
      groups[n].push_back(f);
    }
  }

  std::vector<std::vector<std::uint32_t>> groups;
  std::vector<std::uint8_t> divided;  // per face

 private:
  // Is there more than its own corners and edges, and what is on edges of it that stay whole?
  bool is_met(std::uint32_t f) const {
    const auto points = traces_.points_of(f);
    if (points.empty()) return false;
    std::vector<PointId> corners;
    for (std::uint32_t c = facets_.begin(f); c < facets_.end(f); ++c)
      corners.push_back(facets_.from(c));
    std::sort(corners.begin(), corners.end());
    const std::vector<std::uint32_t> whole = edges_in_rows(f);
    bool only_corners = true;
    for (const PointId p : points) {
      if (std::binary_search(corners.begin(), corners.end(), p)) continue;
      if (!is_on_any(whole, p, p)) return true;
      only_corners = false;
    }
    if (only_corners && corners.size() == 3) return false;
    for (const Trace& t : traces_.of(f)) {
      bool edge = is_on_any(whole, t.from, t.to);
      for (std::uint32_t c = facets_.begin(f); c < facets_.end(f) && !edge; ++c)
        edge = std::minmax(facets_.from(c), facets_.to(c)) == std::minmax(t.from, t.to);
      if (!edge) return true;
    }
    return false;
  }

  std::vector<std::uint32_t> edges_in_rows(std::uint32_t f) const {
    constexpr std::uint32_t few = 16;
    std::vector<std::uint32_t> edges;
    if (rows_.empty() || facets_.size(f) > few) return edges;
    for (std::uint32_t c = facets_.begin(f); c < facets_.end(f); ++c)
      if (rows_.of(facets_.from(c), facets_.to(c)) != none) edges.push_back(c);
    return edges;
  }
  bool is_on_any(const std::vector<std::uint32_t>& edges, PointId p, PointId q) const {
    return std::ranges::any_of(edges, [&](std::uint32_t c) { return is_on(c, p) && is_on(c, q); });
  }
  bool is_on(std::uint32_t c, PointId p) const {
    const PointId from = facets_.from(c), to = facets_.to(c);
    return p == from || p == to ||
           (rows_.of(from, p) == rows_.of(from, to) && kernel_.is_between(from, p, to));
  }

  const Facets& facets_;
  const Traces& traces_;
  const RowLines& rows_;
  const Kernel& kernel_;
  DisjointSets sets_;
};

class Steps {
 public:
  Steps(const Facets& facets, const Kernel& kernel, Counting counting, std::vector<Winding>& steps)
      : facets_(facets), kernel_(kernel), counting_(counting), steps_(steps) {}

  /// The number of the step across a plane where these faces lie.
  std::uint32_t of(PlaneId plane, std::span<const std::uint32_t> cover) {
    Winding step;
    for (const std::uint32_t f : cover)
      add(step, {{facets_.operand[f], 1}}, kernel_.same_direction(plane, facets_.plane[f]) ? 1 : -1,
          counting_);
    const auto [at, made] =
        numbers_.try_emplace(std::move(step), static_cast<std::uint32_t>(steps_.size()));
    if (made) steps_.push_back(at->first);
    return at->second;
  }

 private:
  const Facets& facets_;
  const Kernel& kernel_;
  Counting counting_;
  std::vector<Winding>& steps_;
  std::map<Winding, std::uint32_t> numbers_;
};

class Collector {
 public:
  Collector(const Facets& facets, const EdgeLines& lines, const RowLines& rows,
            const Kernel& kernel, Counting counting)
      : facets_(facets),
        lines_(lines),
        rows_(rows),
        steps_(facets, kernel, counting, result_.steps) {}

  void add_whole(std::uint32_t f) {
    Polygons& to = result_.polygons;
    for (std::uint32_t l = facets_.polygons.first_loop(f); l < facets_.polygons.face_end[f]; ++l) {
      to.add_loop(facets_.polygons.loop(l));
      for (std::uint32_t c = facets_.polygons.loop_begin(l); c < facets_.polygons.loop_end[l]; ++c)
        add_edge(c);
    }
    const std::uint32_t operand = facets_.operand[f];
    if (operand >= whole_step_.size()) whole_step_.resize(operand + 1, none);
    std::uint32_t& step = whole_step_[operand];
    if (step == none) step = steps_.of(facets_.plane[f], std::span(&f, 1));
    end_face(facets_.plane[f], std::span(&f, 1), step, false);
  }

  void add_regions(PlaneId plane, const Regions& regions) {
    std::uint32_t loop = 0, corner = 0;
    for (std::size_t r = 0; r < regions.region_end.size(); ++r) {
      const auto cover = regions.cover_of(r);
      if (cover.size() > 1) {
        ++result_.overlaps;
        result_.first_overlap = std::min(result_.first_overlap, cover[0]);
      }
      const std::uint32_t step = steps_.of(plane, cover);
      const bool keep = !result_.steps[step].empty();
      for (; loop < regions.region_end[r]; ++loop) {
        const std::uint32_t end = regions.loop_end[loop];
        if (keep) {
          result_.polygons.add_loop(std::span(regions.corners).subspan(corner, end - corner));
          result_.across.insert(result_.across.end(), regions.across.begin() + corner,
                                regions.across.begin() + end);
          if (!rows_.empty())
            result_.row.insert(result_.row.end(), regions.row.begin() + corner,
                               regions.row.begin() + end);
        }
        corner = end;
      }
      if (keep) end_face(plane, cover, step, true);
    }
  }

  SubFaces take() { return std::move(result_); }

 private:
  // Of a whole face. In a row it may come to be divided.
  void add_edge(std::uint32_t c) {
    const std::uint32_t row = rows_.of(facets_.from(c), facets_.to(c));
    if (!rows_.empty()) result_.row.push_back(row);
    PlaneId across;
    if (row != none)
      across = lines_.across(c);
    else if (!facets_.second_plane.empty())
      across = facets_.second_plane[c];
    result_.across.push_back(across);
  }

  void end_face(PlaneId plane, std::span<const std::uint32_t> cover, std::uint32_t step,
                bool divided) {
    result_.polygons.end_face(cover.front());
    result_.plane.push_back(plane);
    result_.cover.insert(result_.cover.end(), cover.begin(), cover.end());
    result_.cover_end.push_back(static_cast<std::uint32_t>(result_.cover.size()));
    result_.step_of.push_back(step);
    result_.divided.push_back(divided);
  }

  const Facets& facets_;
  const EdgeLines& lines_;
  const RowLines& rows_;
  SubFaces result_;
  Steps steps_;
  std::vector<std::uint32_t> whole_step_;  // per operand
};

// Where the pieces of a plane cross each other, in all planes.
void divide_planes(std::vector<PlanePieces>& planes, const Facets& facets, const EdgeLines& lines,
                   Geometry& geometry, Kernel& kernel, std::vector<PointId>& first_at,
                   const Traces& traces, const RowLines& rows, const Groups& groups,
                   const Steering& steering) {
  parallel::loop(0, planes.size(), [&](std::size_t i) {
    steering.check();
    planes[i].find_crossings(kernel, lines);
  });
  std::vector<Construction> constructions;
  std::vector<std::size_t> first{0};
  for (const PlanePieces& plane : planes) {
    append(constructions, plane.constructions());
    first.push_back(constructions.size());
  }
  const std::vector<PointId> made = add_points(constructions, geometry, kernel);
  std::vector<PointId> points = made;
  // Pieces meet corners of whole faces in rows.
  for (std::uint32_t f = 0; f < facets.face_count(); ++f) {
    if (groups.divided[f] == 0 && rows.empty()) continue;
    for (const PointId p : traces.points_of(f)) points.push_back(p);
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c)
      points.push_back(facets.from(c));
  }
  unite_places(kernel, std::move(points), first_at);
  parallel::loop(0, planes.size(), [&](std::size_t i) {
    planes[i].divide(kernel, std::span(made).subspan(first[i], first[i + 1] - first[i]), first_at,
                     facets);
  });
}

// Those in pairs or at crowded points, those that touch themselves, and their neighbours: an edge
// lies in both.
std::vector<std::uint8_t> faces_to_look_at(const Facets& facets, const Pairs& pairs,
                                           const std::vector<std::uint8_t>& touches_itself) {
  std::vector<std::uint8_t> wanted(facets.face_count(), 0);
  for (const FacePair& pair : pairs.pairs) wanted[pair.f] = wanted[pair.g] = 1;
  for (const CrowdedPoint& point : pairs.crowded_points)
    for (const std::uint32_t f : point.faces) wanted[f] = 1;
  std::vector<PointId> corners;
  const auto for_each_corner = [&](std::uint32_t f, const auto& visit) {
    for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c) visit(facets.from(c));
  };
  for (std::uint32_t f = 0; f < wanted.size(); ++f)
    if (touches_itself[f]) for_each_corner(f, [&](PointId p) { corners.push_back(p); });
  if (corners.empty()) return wanted;
  std::sort(corners.begin(), corners.end());
  for (std::uint32_t f = 0; f < wanted.size(); ++f)
    for_each_corner(f, [&](PointId p) {
      wanted[f] = wanted[f] || std::binary_search(corners.begin(), corners.end(), p);
    });
  return wanted;
}

}  // namespace

SubFaces arrange(const Facets& facets, const FacetTree& tree, Counting counting, Crowds crowds,
                 Geometry& geometry, Kernel& kernel, const Steering& steering) {
  const std::vector<std::uint8_t> convex = find_convex(facets, kernel);
  const Pairs pairs = find_pairs(facets, tree, convex, kernel, crowds, steering);
  steering.step(0.3);
  const std::vector<std::uint8_t> touches_itself = find_self_touching(facets, convex, kernel);
  const std::vector<std::uint8_t> wanted = pairs.crowded_lines.empty()
                                               ? faces_to_look_at(facets, pairs, touches_itself)
                                               : std::vector<std::uint8_t>(facets.face_count(), 1);
  const EdgeLines lines(facets, wanted, geometry, kernel);
  std::vector<PointId> first_at;
  const Traces traces =
      find_traces(facets, pairs, convex, lines, wanted, geometry, kernel, first_at, steering);
  const RowLines rows(facets, traces, pairs.crowded_lines, kernel);
  steering.step(0.5);
  const Groups groups(facets, pairs.pairs, traces, rows, kernel, touches_itself);
  std::vector<PlanePieces> planes(groups.groups.size());
  parallel::loop(0, planes.size(), [&](std::size_t i) {
    planes[i] = PlanePieces(facets, lines, traces, rows, groups.groups[i], kernel);
  });
  divide_planes(planes, facets, lines, geometry, kernel, first_at, traces, rows, groups, steering);
  std::vector<Regions> regions(planes.size());
  parallel::loop(0, planes.size(), [&](std::size_t i) {
    steering.check();
    regions[i] = find_regions(planes[i], kernel);
  });
  steering.step(0.6);
  Collector collector(facets, lines, rows, kernel, counting);
  for (std::uint32_t f = 0; f < facets.face_count(); ++f)
    if (!groups.divided[f]) collector.add_whole(f);
  for (std::size_t i = 0; i < planes.size(); ++i)
    collector.add_regions(planes[i].plane(), regions[i]);
  SubFaces result = collector.take();
  result.divided_faces =
      static_cast<std::size_t>(std::count(groups.divided.begin(), groups.divided.end(), 1));
  result.first_divided = static_cast<std::uint32_t>(
      std::find(groups.divided.begin(), groups.divided.end(), 1) - groups.divided.begin());
  return result;
}

}  // namespace sectile::arrangement
