#include <algorithm>
#include <string>
#include <utility>

#include "geometry/around_line.h"
#include "import/diagnosis.h"
#include "import/edge_buckets.h"
#include "import/flat_edges.h"
#include "import/polygons.h"
#include "parallel/parallel.h"
#include "parallel/scratch.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

class Matcher {
 public:
  Matcher(const Polygons& polygons, const Kernel& kernel,
          const std::vector<std::uint32_t>& input_vertex)
      : polygons_(polygons),
        kernel_(kernel),
        input_vertex_(input_vertex),
        buckets_(polygons),
        mate_(polygons.corners.size()),
        around_(kernel, -1, Sign::zero) {}

  /// Pairs what runs both ways between two points.
  void pair_plain() {
    using Lines = std::vector<Line>;
    parallel::Scratch<Lines> odd;
    parallel::loop(parallel::Range<std::uint32_t>(0, buckets_.count(), 1024),
                   [&](const auto& range) {
                     odd.lend([&](Lines& lines) {
                       for (std::uint32_t p = range.begin(); p < range.end(); ++p)
                         match_bucket(PointId(p), buckets_[p], lines);
                     });
                   });
    odd.for_each([&](const Lines& some) { lines_.insert(lines_.end(), some.begin(), some.end()); });
    std::sort(lines_.begin(), lines_.end(), [](const Line& a, const Line& b) {
      return std::pair(a.low, a.entries[0].high) < std::pair(b.low, b.entries[0].high);
    });
  }

  /// Is there nothing else?
  bool all_plain() const { return lines_.empty(); }
  std::vector<std::uint32_t> take() { return std::move(mate_); }

  /// The corners of half-edges of which more run one way than the other.
  std::vector<std::uint32_t> open_corners() const {
    std::vector<std::uint32_t> corners;
    for (const Line& line : lines_)
      if (2 * forward_count(line.entries) != line.entries.size())
        for (const LineEntry& e : line.entries) corners.push_back(e.corner);
    return corners;
  }

  /// Resolves all other lines into wedges.
  std::vector<std::uint32_t> pair_wedges() {
    if (!lines_.empty()) find_faces();
    for (const Line& line : lines_) match(line.low, line.entries);
    return std::move(mate_);
  }

 private:
  // More or fewer than two half-edges, or two that run the same way.
  struct Line {
    PointId low;
    std::span<LineEntry> entries;
  };

  void match_bucket(PointId low, std::span<LineEntry> bucket, std::vector<Line>& odd) {
    std::sort(bucket.begin(), bucket.end(), [](const LineEntry& a, const LineEntry& b) {
      return a.high != b.high ? a.high < b.high : a.corner < b.corner;
    });
    for (std::size_t from = 0, to; from < bucket.size(); from = to) {
      for (to = from + 1; to < bucket.size() && bucket[to].high == bucket[from].high;) ++to;
      const auto entries = bucket.subspan(from, to - from);
      if (entries.size() == 2 && entries[0].forward != entries[1].forward)
        pair(entries[0], entries[1]);
      else
        odd.push_back({low, entries});
    }
  }

  void find_faces() {
    face_.resize(polygons_.corners.size());
    for (std::uint32_t f = 0; f < polygons_.face_count(); ++f)
      for (std::uint32_t l = polygons_.first_loop(f); l < polygons_.face_end[f]; ++l)
        for (std::uint32_t i = polygons_.loop_begin(l); i < polygons_.loop_end[l]; ++i)
          face_[i] = f;
  }

  static std::size_t forward_count(std::span<const LineEntry> entries) {
    return static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(),
                                                  [](const LineEntry& e) { return e.forward; }));
  }

  void match(PointId low, std::span<LineEntry> entries) {
    const std::size_t forward = forward_count(entries);
    if (2 * forward != entries.size()) refuse(low, entries, forward);
    sort_around(low, entries);
    // Material lies between a backward half-plane and the forward one that follows it.
    const std::size_t n = entries.size();
    for (std::size_t i = 0; i < n; ++i) {
      const LineEntry &e = entries[i], &next = entries[i + 1 < n ? i + 1 : 0];
      if (e.forward == next.forward || tied(e, next)) refuse_overlap(low, e, next);
      if (!e.forward) pair(e, next);
    }
  }

  void pair(const LineEntry& a, const LineEntry& b) {
    mate_[a.corner] = b.corner;
    mate_[b.corner] = a.corner;
  }

  PlaneId plane(const LineEntry& e) const { return PlaneId(face_[e.corner]); }

  LineSide side(const LineEntry& e) const { return {PlaneId(face_[e.corner]), e.forward}; }

  void sort_around(PointId low, std::span<LineEntry> entries) {
    int axis = -1;
    for (const LineEntry& e : entries) {
      axis = kernel_.cross_axis(side(entries[0]).plane, side(e).plane);
      if (axis >= 0) break;
    }
    const Sign up = axis < 0 ? Sign::zero : kernel_.compare(low, entries[0].high, axis);
    around_ = AroundLine(kernel_, axis, up);
    const LineSide start = side(entries[0]);
    std::sort(entries.begin(), entries.end(), [&](const LineEntry& a, const LineEntry& b) {
      return around_.before(start, side(a), side(b), a.corner < b.corner);
    });
  }

  bool tied(const LineEntry& a, const LineEntry& b) const { return around_.tied(side(a), side(b)); }

  std::uint32_t source(const LineEntry& e) const { return polygons_.source[face_[e.corner]]; }
  std::uint32_t vertex(PointId p) const { return input_vertex_[p.value()]; }
  std::string face_in_words(const LineEntry& e) const { return std::to_string(source(e)); }
  std::string vertex_in_words(PointId p) const {
    return std::to_string(vertex(p)) + " " + in_words(kernel_.geometry().position(p));
  }
  std::string edge_in_words(PointId low, const LineEntry& e) const {
    const auto [from, to] = e.forward ? std::pair(low, e.high) : std::pair(e.high, low);
    return "the edge from vertex " + vertex_in_words(from) + " to vertex " + vertex_in_words(to);
  }

  [[noreturn]] void refuse(PointId low, std::span<const LineEntry> entries,
                           std::size_t forward) const {
    const LineEntry& first = entries[0];
    if (entries.size() == 1)
      throw InvalidSolid(InvalidSolid::Reason::open,
                         "the surface is open: " + edge_in_words(low, first) + " of face " +
                             face_in_words(first) +
                             " has no face on its other side; close the hole there",
                         source(first), vertex(low));
    if (forward == 0 || forward == entries.size())
      throw InvalidSolid(InvalidSolid::Reason::inconsistent,
                         "faces " + face_in_words(first) + " and " + face_in_words(entries[1]) +
                             " run the same way along " + edge_in_words(low, first) +
                             "; turn one of them around",
                         source(first), vertex(low));
    throw InvalidSolid(
        entries.size() % 2 == 1 ? InvalidSolid::Reason::open : InvalidSolid::Reason::inconsistent,
        "the faces do not fit together: along " + edge_in_words(low, first) + ", " +
            std::to_string(forward) + " run one way and " +
            std::to_string(entries.size() - forward) + " the other, among them face " +
            face_in_words(first) + "; add what is missing there or turn faces around",
        source(first), vertex(low));
  }

  [[noreturn]] void refuse_overlap(PointId low, const LineEntry& a, const LineEntry& b) const {
    if (tied(a, b) && a.forward != b.forward)
      throw InvalidSolid(InvalidSolid::Reason::self_intersecting,
                         "faces " + face_in_words(a) + " and " + face_in_words(b) +
                             " lie on each other back to back along " + edge_in_words(low, a) +
                             "; remove them where they do, or unite the parts as two solids",
                         source(a), vertex(low));
    throw InvalidSolid(InvalidSolid::Reason::self_intersecting,
                       "faces " + face_in_words(a) + " and " + face_in_words(b) +
                           " overlap, or material lies on both sides of them, along " +
                           edge_in_words(low, a) +
                           "; make two solids of what overlaps and unite them",
                       source(a), vertex(low));
  }

  const Polygons& polygons_;
  const Kernel& kernel_;
  const std::vector<std::uint32_t>& input_vertex_;
  EdgeBuckets buckets_;
  std::vector<Line> lines_;
  std::vector<std::uint32_t> mate_;
  std::vector<std::uint32_t> face_;  // per corner, if it is needed
  AroundLine around_;                // that of the edge that is looked at
};

}  // namespace

std::vector<std::uint32_t> match_plain_edges(const Polygons& polygons, const Kernel& kernel) {
  const std::vector<std::uint32_t> no_vertex;  // nothing is refused
  Matcher matcher(polygons, kernel, no_vertex);
  matcher.pair_plain();
  return matcher.all_plain() ? matcher.take() : std::vector<std::uint32_t>();
}

std::vector<std::uint32_t> match_edges(Polygons& polygons, const Kernel& kernel,
                                       const std::vector<std::uint32_t>& input_vertex) {
  std::vector<std::uint32_t> open;
  {
    Matcher matcher(polygons, kernel, input_vertex);
    matcher.pair_plain();
    open = matcher.open_corners();
    if (open.empty()) return matcher.pair_wedges();
  }
  divide_open_edges(polygons, kernel, open);
  Matcher matcher(polygons, kernel, input_vertex);
  matcher.pair_plain();
  return matcher.pair_wedges();
}

}  // namespace sectile
