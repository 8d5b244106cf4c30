#include "repair/borders.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "import/edge_buckets.h"

namespace sectile {
namespace {

// Calls visit(low, entries) for all half-edges between two points.
template <class Visit>
void for_each_line(const Polygons& polygons, const Visit& visit) {
  EdgeBuckets buckets(polygons);
  for (std::uint32_t p = 0; p < buckets.count(); ++p) {
    const auto bucket = buckets[p];
    std::sort(bucket.begin(), bucket.end(), [](const LineEntry& a, const LineEntry& b) {
      return a.high != b.high ? a.high < b.high : a.corner < b.corner;
    });
    for (std::size_t from = 0, to; from < bucket.size(); from = to) {
      for (to = from + 1; to < bucket.size() && bucket[to].high == bucket[from].high;) ++to;
      visit(PointId(p), bucket.subspan(from, to - from));
    }
  }
}

int sum_of(std::span<const LineEntry> entries) {
  int sum = 0;
  for (const LineEntry& e : entries) sum += e.forward ? 1 : -1;
  return sum;
}

bool is_open(std::span<const LineEntry> entries, Balance balance) {
  return balance == Balance::oriented ? sum_of(entries) != 0 : entries.size() % 2 != 0;
}

std::vector<std::uint32_t> faces_of_corners(const Polygons& polygons) {
  std::vector<std::uint32_t> face(polygons.corners.size());
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f)
    for (std::uint32_t c = polygons.loop_begin(polygons.first_loop(f));
         c < polygons.loop_end[polygons.face_end[f] - 1]; ++c)
      face[c] = f;
  return face;
}

// Walks along edges that leave each point as often as they arrive, or, without directions, meet it
// an even number of times.
class LoopTracer {
 public:
  explicit LoopTracer(bool directed) : directed_(directed) {}

  void add(PointId from, PointId to, std::uint32_t face) {
    const auto number = static_cast<std::uint32_t>(edges_.size());
    edges_.push_back({from, to, face, false});
    leaving_[from].push_back(number);
    if (!directed_) leaving_[to].push_back(number);
  }

  std::vector<BorderLoop> run() {
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
      while (!edges_[e].used) walk(edges_[e].from);
    return std::move(loops_);
  }

 private:
  struct Edge {
    PointId from, to;
    std::uint32_t face;
    bool used;
  };

  // Whenever the path comes back to one of its points, what lies between is a loop.
  void walk(PointId start) {
    std::vector<std::pair<PointId, std::uint32_t>> path;  // points, each with the edge that leaves
    std::map<PointId, std::size_t> place;
    for (PointId at = start;;) {
      if (const auto seen = place.find(at); seen != place.end()) {
        const std::size_t first = seen->second;
        BorderLoop loop{{}, edges_[path[first].second].face};
        for (std::size_t i = first; i < path.size(); ++i) {
          loop.corners.push_back(path[i].first);
          place.erase(path[i].first);
        }
        path.resize(first);
        loops_.push_back(std::move(loop));
        if (path.empty() && at == start) return;
      }
      const std::uint32_t e = take(at);
      place[at] = path.size();
      path.push_back({at, e});
      at = edges_[e].from == at ? edges_[e].to : edges_[e].from;
    }
  }

  std::uint32_t take(PointId from) {
    auto& edges = leaving_[from];
    while (edges_[edges.back()].used) edges.pop_back();
    const std::uint32_t e = edges.back();
    edges_[e].used = true;
    return e;
  }

  bool directed_;
  std::vector<Edge> edges_;
  std::map<PointId, std::vector<std::uint32_t>> leaving_;
  std::vector<BorderLoop> loops_;
};

// Faces that meet in an edge with no third one, and whether they contradict each other there.
class Orienter {
 public:
  explicit Orienter(Polygons& polygons) : polygons_(polygons), links_(polygons.face_count()) {
    const std::vector<std::uint32_t> face = faces_of_corners(polygons);
    for_each_line(polygons, [&](PointId, std::span<const LineEntry> entries) {
      if (entries.size() != 2) return;
      const std::uint32_t f = face[entries[0].corner], g = face[entries[1].corner];
      const bool turned = entries[0].forward == entries[1].forward;
      contradictions_ += turned;
      links_[f].push_back({g, turned});
      links_[g].push_back({f, turned});
    });
  }

  std::vector<std::uint32_t> run() {
    std::vector<std::uint32_t> turned;
    if (contradictions_ == 0) return turned;
    way_.assign(polygons_.face_count(), 0);
    for (std::uint32_t f = 0; f < way_.size(); ++f)
      if (way_[f] == 0) spread(f, turned);
    std::sort(turned.begin(), turned.end());
    for (const std::uint32_t f : turned) turn(f);
    return turned;
  }

 private:
  struct Link {
    std::uint32_t face;
    bool turned;
  };

  void spread(std::uint32_t first, std::vector<std::uint32_t>& turned) {
    std::vector<std::uint32_t> piece{first};
    way_[first] = 1;
    std::size_t other_way = 0;
    for (std::size_t i = 0; i < piece.size(); ++i)
      for (const Link& link : links_[piece[i]]) {
        if (way_[link.face] != 0) continue;  // an edge that contradicts this stays open
        way_[link.face] = link.turned ? static_cast<std::int8_t>(-way_[piece[i]]) : way_[piece[i]];
        other_way += way_[link.face] < 0;
        piece.push_back(link.face);
      }
    const std::int8_t turn = 2 * other_way > piece.size() ? 1 : -1;
    for (const std::uint32_t f : piece)
      if (way_[f] == turn) turned.push_back(f);
  }

  void turn(std::uint32_t f) {
    for (std::uint32_t l = polygons_.first_loop(f); l < polygons_.face_end[f]; ++l)
      std::reverse(polygons_.corners.begin() + polygons_.loop_begin(l),
                   polygons_.corners.begin() + polygons_.loop_end[l]);
  }

  Polygons& polygons_;
  std::vector<std::vector<Link>> links_;
  std::size_t contradictions_ = 0;
  std::vector<std::int8_t> way_;
};

// Faces by what they are open by: how many more half-edges run along each edge than back.
class CopyFinder {
 public:
  CopyFinder(const Polygons& polygons, Balance balance) : polygons_(polygons), balance_(balance) {
    for_each_line(polygons, [&](PointId low, std::span<const LineEntry> entries) {
      if (is_open(entries, balance))
        excess_[{low, entries[0].high}] = balance == Balance::oriented ? sum_of(entries) : 1;
    });
  }

  std::vector<std::uint32_t> run() {
    std::map<std::vector<PointId>, std::vector<std::uint32_t>> alike;
    for (std::uint32_t f = 0; f < polygons_.face_count(); ++f)
      if (is_superfluous(f)) ++candidates_;
    if (candidates_ == 0) return {};
    for (std::uint32_t f = 0; f < polygons_.face_count(); ++f) alike[corners(f)].push_back(f);
    std::vector<std::uint32_t> removed;
    for (const auto& [corners, faces] : alike)
      for (std::size_t i = faces.size(), left = faces.size(); i-- > 0 && left > 1;)
        if (is_superfluous(faces[i])) {
          take(faces[i]);
          removed.push_back(faces[i]);
          --left;
        }
    std::sort(removed.begin(), removed.end());
    return removed;
  }

 private:
  std::vector<PointId> corners(std::uint32_t f) const {
    const auto span = polygons_.face_corners(f);
    std::vector<PointId> sorted(span.begin(), span.end());
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }

  template <class Visit>
  void for_each_edge(std::uint32_t f, const Visit& visit) const {
    const auto loop = polygons_.face_corners(f);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const PointId p = loop[i], q = loop[i + 1 < loop.size() ? i + 1 : 0];
      visit(std::pair(std::min(p, q), std::max(p, q)), p < q ? 1 : -1);
    }
  }

  bool is_superfluous(std::uint32_t f) const {
    bool all = polygons_.face_end[f] == polygons_.first_loop(f) + 1;
    for_each_edge(f, [&](const std::pair<PointId, PointId>& edge, int way) {
      if (!all) return;
      const auto at = excess_.find(edge);
      all = at != excess_.end() && at->second != 0 &&
            (balance_ == Balance::parity || (at->second > 0) == (way > 0));
    });
    return all;
  }
  void take(std::uint32_t f) {
    for_each_edge(f, [&](const std::pair<PointId, PointId>& edge, int way) {
      excess_[edge] -= balance_ == Balance::parity ? 1 : way;
    });
  }

  const Polygons& polygons_;
  Balance balance_;
  std::size_t candidates_ = 0;
  std::map<std::pair<PointId, PointId>, int> excess_;  // of open edges
};

}  // namespace

std::vector<std::uint32_t> remove_copies(Polygons& polygons, Balance balance) {
  const std::vector<std::uint32_t> removed = CopyFinder(polygons, balance).run();
  if (removed.empty()) return removed;
  Polygons kept;
  auto next = removed.begin();
  for (std::uint32_t f = 0; f < polygons.face_count(); ++f)
    if (next != removed.end() && *next == f)
      ++next;
    else
      kept.add_face(polygons, f);
  polygons = std::move(kept);
  return removed;
}

std::vector<std::uint32_t> open_corners(const Polygons& polygons, Balance balance) {
  std::vector<std::uint32_t> corners;
  for_each_line(polygons, [&](PointId, std::span<const LineEntry> entries) {
    if (is_open(entries, balance))
      for (const LineEntry& e : entries) corners.push_back(e.corner);
  });
  return corners;
}

std::vector<BorderLoop> border_loops(const Polygons& polygons, Balance balance) {
  std::vector<std::uint32_t> face;
  LoopTracer tracer(balance == Balance::oriented);
  for_each_line(polygons, [&](PointId low, std::span<const LineEntry> entries) {
    if (!is_open(entries, balance)) return;
    if (face.empty()) face = faces_of_corners(polygons);
    const int sum = sum_of(entries);
    const PointId high = entries[0].high;
    const bool backward = sum > 0;  // what is missing
    const std::uint32_t beside = face[entries[0].corner];
    const int missing = balance == Balance::oriented ? std::abs(sum) : 1;
    for (int i = 0; i < missing; ++i)
      backward ? tracer.add(high, low, beside) : tracer.add(low, high, beside);
  });
  return tracer.run();
}

std::vector<std::uint32_t> orient(Polygons& polygons) {
  return Orienter(polygons).run();
}

}  // namespace sectile
