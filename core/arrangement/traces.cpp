#include "arrangement/traces.h"

#include <algorithm>

#include "boolean/collect.h"
#include "parallel/parallel.h"

namespace sectile::arrangement {
namespace {

// A point in which the two faces of a pair meet: a corner, or a construction that is still to be
// made a point.
struct Contact {
  std::uint32_t pair;
  PointId point;
  std::uint32_t made = none;  ///< index of the construction
};

struct Contacts {
  std::vector<Contact> contacts;
  std::vector<Construction> constructions;
};

class ContactFinder {
 public:
  ContactFinder(const Facets& facets, const EdgeLines& lines, const FaceLocator& locator,
                const Kernel& kernel)
      : facets_(facets), lines_(lines), locator_(locator), kernel_(kernel) {}

  void operator()(std::uint32_t number, const FacePair& pair, Contacts& out) const {
    const std::uint32_t f = pair.f, g = pair.g;
    for (const auto& [face, other] : {std::pair(f, g), std::pair(g, f)}) {
      if (pair.how == Meeting::crossing)
        pierce(number, face, other, out);
      else
        find_corners(number, face, other, out);
    }
  }

 private:
  // The corners of a face on the plane of another one, and the edges that go through it.
  void pierce(std::uint32_t number, std::uint32_t face, std::uint32_t other, Contacts& out) const {
    const PlaneId plane = facets_.plane[other];
    locator_.for_each_near(face, other, [&](std::uint32_t c) {
      const PointId u = facets_.from(c), v = facets_.to(c);
      const Sign at_u = is_corner(other, u) ? Sign::zero : kernel_.side(u, plane);
      if (at_u == Sign::zero) {
        add_corner(number, u, other, out);
        return;
      }
      if (kernel_.side(v, plane) != -at_u) return;
      const Construction how = lines_.cut(c, plane);
      if (!locator_.contains(other, Probe(kernel_, u, v, how))) return;
      out.contacts.push_back(
          {number, PointId(), static_cast<std::uint32_t>(out.constructions.size())});
      out.constructions.push_back(how);
    });
  }

  void find_corners(std::uint32_t number, std::uint32_t face, std::uint32_t other,
                    Contacts& out) const {
    locator_.for_each_near(
        face, other, [&](std::uint32_t c) { add_corner(number, facets_.from(c), other, out); });
  }

  void add_corner(std::uint32_t number, PointId corner, std::uint32_t other, Contacts& out) const {
    if (is_corner(other, corner) || locator_.contains(other, Probe(kernel_, corner)))
      out.contacts.push_back({number, corner, none});
  }

  bool is_corner(std::uint32_t face, PointId p) const {
    if (facets_.size(face) > 16) return false;
    for (std::uint32_t c = facets_.begin(face); c < facets_.end(face); ++c)
      if (facets_.from(c) == p) return true;
    return false;
  }

  const Facets& facets_;
  const EdgeLines& lines_;
  const FaceLocator& locator_;
  const Kernel& kernel_;
};

struct PairTraces {
  std::vector<std::pair<std::uint32_t, Trace>> traces;  // with the face
  std::vector<std::pair<std::uint32_t, PointId>> points;
};

// From the points of a pair to the segments between them.
class TraceFinder {
 public:
  TraceFinder(const Facets& facets, const std::vector<std::uint8_t>& convex,
              const FaceLocator& locator, const Kernel& kernel)
      : facets_(facets), convex_(convex), locator_(locator), kernel_(kernel) {}

  void operator()(const FacePair& pair, std::vector<PointId>& points, PairTraces& out) const {
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    for (const PointId p : points) {
      out.points.push_back({pair.f, p});
      out.points.push_back({pair.g, p});
    }
    if (pair.how != Meeting::crossing || points.size() < 2) return;
    const PlaneId a = facets_.plane[pair.f], b = facets_.plane[pair.g];
    const int axis = kernel_.cross_axis(a, b);
    std::sort(points.begin(), points.end(),
              [&](PointId p, PointId q) { return kernel_.compare(p, q, axis) == Sign::positive; });
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      if (!is_within(pair.f, points[i], points[i + 1]) ||
          !is_within(pair.g, points[i], points[i + 1]))
        continue;
      out.traces.push_back({pair.f, {points[i], points[i + 1], b}});
      out.traces.push_back({pair.g, {points[i], points[i + 1], a}});
    }
  }

 private:
  // Nothing changes between neighbouring points: all of the segment is in the face, or nothing.
  bool is_within(std::uint32_t face, PointId p, PointId q) const {
    return convex_[face] || locator_.contains(face, Middle(kernel_, p, q));
  }

  const Facets& facets_;
  const std::vector<std::uint8_t>& convex_;
  const FaceLocator& locator_;
  const Kernel& kernel_;
};

// Puts items into the order of their faces.
template <class T>
void sort_by_face(const std::vector<std::vector<std::pair<std::uint32_t, T>>>& blocks,
                  std::size_t faces, std::vector<std::uint32_t>& end, std::vector<T>& items) {
  end.assign(faces, 0);
  std::size_t count = 0;
  for (const auto& block : blocks) {
    count += block.size();
    for (const auto& [face, item] : block) ++end[face];
  }
  std::vector<std::uint32_t> at(faces);
  std::uint32_t sum = 0;
  for (std::size_t f = 0; f < faces; ++f) {
    at[f] = sum;
    sum += end[f];
    end[f] = sum;
  }
  items.resize(count);
  for (const auto& block : blocks)
    for (const auto& [face, item] : block) items[at[face]++] = item;
}

// All contacts, in the order of the pairs, as points.
struct PairPoints {
  std::vector<std::uint32_t> end;  // per pair
  std::vector<PointId> points;
};

PairPoints collect_points(std::vector<Contacts>& found, std::size_t pairs, Geometry& geometry,
                          Kernel& kernel) {
  std::vector<Construction> constructions;
  for (Contacts& block : found) {
    const auto offset = static_cast<std::uint32_t>(constructions.size());
    append(constructions, block.constructions);
    for (Contact& c : block.contacts)
      if (c.made != none) c.made += offset;
  }
  const std::vector<PointId> made = add_points(constructions, geometry, kernel);
  PairPoints result;
  result.end.assign(pairs, 0);
  for (const Contacts& block : found)
    for (const Contact& c : block.contacts) {
      result.points.push_back(c.made == none ? c.point : made[c.made]);
      result.end[c.pair] = static_cast<std::uint32_t>(result.points.size());
    }
  for (std::size_t i = 1; i < pairs; ++i)
    result.end[i] = std::max(result.end[i], result.end[i - 1]);
  return result;
}

}  // namespace

std::vector<PointId> add_points(const std::vector<Construction>& constructions, Geometry& geometry,
                                Kernel& kernel) {
  std::vector<ConstructedPoint> points(constructions.size());
  parallel::loop(parallel::Range<std::size_t>(0, points.size(), 64), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i)
      points[i] = kernel.construct(constructions[i]);
  });
  std::vector<PointId> made(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    made[i] = add_constructed(geometry, constructions[i], points[i]);
  kernel.refresh();
  return made;
}

namespace {

std::vector<PointId> add_crowded_points(const std::vector<CrowdedPoint>& crowded,
                                        Geometry& geometry, Kernel& kernel) {
  std::vector<Construction> constructions;
  for (const CrowdedPoint& point : crowded) constructions.push_back(point.how);
  return add_points(constructions, geometry, kernel);
}

// Whether it is in pairs or not, a face has the points in its edges.
std::vector<std::pair<std::uint32_t, PointId>> points_of_faces(
    const std::vector<CrowdedPoint>& crowded, const std::vector<PointId>& points,
    const std::vector<PointId>& first_at) {
  std::vector<std::pair<std::uint32_t, PointId>> all;
  for (std::size_t i = 0; i < crowded.size(); ++i)
    for (const std::uint32_t f : crowded[i].faces) all.push_back({f, first_at[points[i].value()]});
  return all;
}

}  // namespace

Traces find_traces(const Facets& facets, const Pairs& found_pairs,
                   const std::vector<std::uint8_t>& convex, const EdgeLines& lines,
                   const std::vector<std::uint8_t>& wanted, Geometry& geometry, Kernel& kernel,
                   std::vector<PointId>& first_at, const Steering& steering) {
  const std::vector<FacePair>& pairs = found_pairs.pairs;
  const FaceLocator locator(facets, lines, wanted, kernel);
  const ContactFinder find(facets, lines, locator, kernel);
  constexpr std::size_t block = 64;
  auto found = collect<Contacts>(pairs.size(), block, [&](std::size_t i, Contacts& out) {
    if (i % block == 0) steering.check();
    // Faces in one plane that overlap find each other in the plane.
    if (pairs[i].how != Meeting::overlapping) find(static_cast<std::uint32_t>(i), pairs[i], out);
  });
  PairPoints contacts = collect_points(found, pairs.size(), geometry, kernel);
  const std::vector<PointId> crowded =
      add_crowded_points(found_pairs.crowded_points, geometry, kernel);
  {
    std::vector<PointId> points = contacts.points;
    append(points, crowded);
    for (std::size_t f = 0; f < facets.face_count(); ++f)
      if (wanted[f])
        for (std::uint32_t c = facets.begin(f); c < facets.end(f); ++c)
          points.push_back(facets.from(c));
    unite_places(kernel, std::move(points), first_at);
  }
  const TraceFinder trace(facets, convex, locator, kernel);
  struct Output {
    PairTraces traces;
    std::vector<PointId> scratch;
  };
  auto outputs = collect<Output>(pairs.size(), block, [&](std::size_t i, Output& out) {
    out.scratch.clear();
    for (std::uint32_t k = i > 0 ? contacts.end[i - 1] : 0; k < contacts.end[i]; ++k)
      out.scratch.push_back(first_at[contacts.points[k].value()]);
    trace(pairs[i], out.scratch, out.traces);
  });
  std::vector<std::vector<std::pair<std::uint32_t, Trace>>> traces;
  std::vector<std::vector<std::pair<std::uint32_t, PointId>>> points;
  for (Output& out : outputs) {
    traces.push_back(std::move(out.traces.traces));
    points.push_back(std::move(out.traces.points));
  }
  points.push_back(points_of_faces(found_pairs.crowded_points, crowded, first_at));
  Traces result;
  sort_by_face(traces, facets.face_count(), result.trace_end, result.traces);
  sort_by_face(points, facets.face_count(), result.point_end, result.points);
  return result;
}

}  // namespace sectile::arrangement
