#include "search/space_partition.h"

#include <algorithm>
#include <numeric>
#include <random>

#include "numbers/threshold.h"
#include "parallel/parallel.h"
#include "search/approximate.h"

namespace sectile {

using namespace approximate;

namespace {

// A thing that has so few others beside it in a cell is compared with them.
constexpr std::size_t few_others = threshold(24, 1);
// A choice of a plane takes as long as so many pairs.
constexpr std::size_t pairs_for_a_plane = threshold(256, 2);
constexpr int most_levels = 6;

Vec3 farthest_point_from(const Vec3& from, std::span<const Vec3> points) {
  return *std::ranges::max_element(points, {}, [&](const Vec3& p) {
    const Vec3 off = p - from;
    return dot(off, off);
  });
}

double distance_from_segment(const Vec3& p, const Vec3& from, const Vec3& to) {
  const Vec3 along = to - from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(p - from, along) / square, 0.0, 1.0) : 0;
  const Vec3 off = p - (from + share * along);
  return std::sqrt(dot(off, off));
}

double reach(const SpacePartition::Rod& rod) {
  return std::max(max_norm(rod.from), max_norm(rod.to));
}

double error(double reach) {
  return 0x1p-44 * reach + 0x1p-500;
}

}  // namespace

SpacePartition::Rod::Rod(std::span<const Vec3> points)
    : from(farthest_point_from(points[0], points)), to(farthest_point_from(from, points)) {
  double most = 0;
  for (const Vec3& p : points) most = std::max(most, distance_from_segment(p, from, to));
  radius = {most, most};
}

// A value along a normal is a sum of three products, and so is the error of a rod; a place that is
// cut out of a rod has a few more roundings. All are less than 64 units of the greatest coordinate
// of the rod, as what a plane cuts out is within it. Lengths whose squares underflow are less than
// 2^-500; with numbers near the end of doubles nothing is certain.
SpacePartition::SpacePartition(std::vector<Rod> rods, std::vector<std::uint32_t> labels,
                               Planes planes)
    : rods_(std::move(rods)), labels_(std::move(labels)), planes_(planes) {
  for (Rod& rod : rods_) {
    is_certain_ &= reach(rod) < 0x1p500;
    for (double& radius : rod.radius) radius += error(reach(rod));
  }
}

SpacePartition::SpacePartition(std::vector<Rod> rods, std::vector<std::uint32_t> labels,
                               std::vector<Triangle> triangles)
    : SpacePartition(std::move(rods), std::move(labels)) {
  triangles_ = std::move(triangles);
}

// Pieces come by their labels.
class SpacePartition::PairCount {
 public:
  void add(std::uint32_t label) {
    if (label != label_ || label == no_label) of_label_ = 0;
    label_ = label;
    pairs_ += count_++ - of_label_++;
  }
  std::size_t pairs() const { return pairs_; }
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0, of_label_ = 0, pairs_ = 0;
  std::uint32_t label_ = no_label;
};

// Tries planes on a sample of the pieces. Where many things have ends in a few points, planes
// through three ends often cut none of them; where they lie in layers, those along two of them;
// where triangles hardly touch along one line, those of the triangles.
class SpacePartition::PlaneChoice {
 public:
  PlaneChoice(const SpacePartition& space, const Cell& cell) : space_(space), random_(cell.seed) {
    const std::size_t count = std::min(cell.pieces.size(), sample_size);
    for (std::size_t i = 0; i < count; ++i)
      sample_.push_back(cell.pieces[i * cell.pieces.size() / count]);
  }

  Plane best() {
    if (space_.planes_ == Planes::through_origin)
      try_through_origin();
    else
      try_all();
    return best_;
  }

 private:
  static constexpr std::size_t sample_size = 32;
  static constexpr int tries = 4;

  void try_all() {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) try_through_middle(axis);
    for (int i = 0; i < tries; ++i) {
      const Rod &rod = any_rod(), &other = any_rod();
      const Vec3 along = rod.to - rod.from, across = cross(along, any_end() - rod.from);
      const Vec3 &p = any_end(), &q = any_end(), &r = any_end();  // in this order
      try_through_three(p, q, r);
      if (const Triangle* const t = any_triangle()) try_through_three((*t)[0], (*t)[1], (*t)[2]);
      try_through_middle(across);
      try_through_middle(cross(along, other.to - other.from));
      try_through_middle(cross(along, across));
      try_through_middle(along);
    }
  }

  // Those that hold a rod cut few others, if few cross each other.
  void try_through_origin() {
    for (int i = 0; i < 2 * tries; ++i) {
      const Rod& rod = any_rod();
      const Vec3 &p = any_end(), &q = any_end();
      for (const Vec3& normal : {cross(rod.from, rod.to), cross(p, q)})
        if (is_usable(normal)) try_plane({unit(normal), 0});
    }
  }

  const Rod& any_rod() { return space_.rods_[sample_[random_() % sample_.size()].thing]; }
  const Triangle* any_triangle() {
    if (space_.triangles_.empty()) return nullptr;
    return &space_.triangles_[sample_[random_() % sample_.size()].thing];
  }
  const Vec3& any_end() {
    const Rod& rod = any_rod();
    return random_() % 2 == 0 ? rod.from : rod.to;
  }

  static bool is_usable(const Vec3& normal) {
    const double square = dot(normal, normal);
    return square > 0x1p-900 && square < 0x1p900;
  }
  static Vec3 unit(const Vec3& normal) { return (1 / std::sqrt(dot(normal, normal))) * normal; }

  void try_through_three(const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec3 normal = cross(q - p, r - p);
    if (is_usable(normal)) try_plane({unit(normal), dot(unit(normal), p)});
  }

  // Where there is most room between the middles of two pieces, of those not too far outside.
  void try_through_middle(const Vec3& normal) {
    if (!is_usable(normal)) return;
    const Vec3 up = unit(normal);
    values_.clear();
    for (const Piece& piece : sample_)
      values_.push_back(dot(up, space_.at(piece, (piece.from + piece.to) / 2)));
    std::ranges::sort(values_);
    const std::size_t count = values_.size();
    std::size_t best = count / 2;
    for (std::size_t i = count / 4 + 1; i < count - count / 4; ++i)
      if (values_[i] - values_[i - 1] > values_[best] - values_[best - 1]) best = i;
    try_plane({up, (values_[best] + values_[best - 1]) / 2});
  }

  void try_plane(const Plane& plane) {
    PairCount below, above;
    for (const Piece& piece : sample_) {
      const double p = dot(plane.normal, space_.at(piece, piece.from)),
                   q = dot(plane.normal, space_.at(piece, piece.to));
      const Rod& rod = space_.rods_[piece.thing];
      const double at_p = rod.radius_at(piece.from), at_q = rod.radius_at(piece.to);
      if (std::min(p - at_p, q - at_q) <= plane.at && !space_.is_above(plane, piece.thing))
        below.add(space_.labels_[piece.thing]);
      if (std::max(p + at_p, q + at_q) >= plane.at && !space_.is_above(plane.turned(), piece.thing))
        above.add(space_.labels_[piece.thing]);
    }
    const std::size_t pairs = below.pairs() + above.pairs();
    if (pairs >= fewest_ || std::max(below.count(), above.count()) == sample_.size()) return;
    fewest_ = pairs;
    best_ = plane;
  }

  const SpacePartition& space_;
  std::minstd_rand random_;
  std::vector<Piece> sample_;
  std::vector<double> values_;
  Plane best_{{1, 0, 0}, 0};
  std::size_t fewest_ = std::numeric_limits<std::size_t>::max();
};

std::vector<SpacePartition::Cell> SpacePartition::cells(std::size_t least) const {
  std::vector<Cell> cells{whole()};
  while (cells.size() < least) {
    std::vector<std::vector<Cell>> parts(cells.size());
    parallel::loop(0, cells.size(), [&](std::size_t i) { parts[i] = divided(cells[i]); });
    std::vector<Cell> finer;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (parts[i].empty()) parts[i].push_back(std::move(cells[i]));
      std::ranges::move(parts[i], std::back_inserter(finer));
    }
    if (finer.size() == cells.size()) return finer;
    cells = std::move(finer);
  }
  return cells;
}

SpacePartition::Cell SpacePartition::whole() const {
  Cell all;
  for (std::uint32_t i = 0; i < rods_.size(); ++i) all.pieces.push_back({i, 0, 1});
  const auto label = [&](const Piece& piece) { return labels_[piece.thing]; };
  std::ranges::stable_sort(all.pieces, {}, label);
  PairCount count;
  for (const Piece& piece : all.pieces) count.add(label(piece));
  all.pairs = count.pairs();
  return all;
}

// Among things in all directions one plane cuts so many that pairs hardly become fewer, and between
// curved layers one finds room only where the others were cut short. So several are tried, one
// after the other, but not longer than it takes to test the pairs.
std::vector<SpacePartition::Cell> SpacePartition::divided(const Cell& cell) const {
  if (!is_worth_dividing(cell)) return {};
  std::vector<Cell> parts = halves(cell);
  for (int level = 0; !are_fewer(parts, cell); ++level) {
    if (level == most_levels || (pairs_for_a_plane << level) > cell.pairs) return {};
    std::vector<Cell> finer;
    for (Cell& part : parts) {
      if (is_worth_dividing(part))
        std::ranges::move(halves(part), std::back_inserter(finer));
      else
        finer.push_back(std::move(part));
    }
    parts = std::move(finer);
  }
  return parts;
}

bool SpacePartition::is_worth_dividing(const Cell& cell) const {
  return is_certain_ && cell.pairs > few_others * cell.pieces.size();
}

bool SpacePartition::are_fewer(std::span<const Cell> parts, const Cell& whole) {
  std::size_t pairs = 0;
  for (const Cell& part : parts) pairs += part.pairs;
  return pairs < whole.pairs - whole.pairs / 8;
}

std::vector<SpacePartition::Cell> SpacePartition::halves(const Cell& cell) const {
  const Plane plane = PlaneChoice(*this, cell).best();
  std::vector<Cell> halves{below(plane, cell), below(plane.turned(), cell)};
  halves[0].seed = 2 * cell.seed;
  halves[1].seed = 2 * cell.seed + 1;
  return halves;
}

SpacePartition::Cell SpacePartition::below(const Plane& plane, const Cell& cell) const {
  Cell half;
  PairCount count;
  for (const Piece& piece : cell.pieces)
    if (const auto part = below(plane, piece)) {
      half.pieces.push_back(*part);
      count.add(labels_[piece.thing]);
    }
  half.pairs = count.pairs();
  return half;
}

// A point of the thing is no farther from the plane than the place on the rod it is nearest to, but
// for the radius: what is cut off has none below the plane. Comparisons with what is not a number
// cut nothing off.
std::optional<SpacePartition::Piece> SpacePartition::below(const Plane& plane,
                                                           const Piece& piece) const {
  const Rod& rod = rods_[piece.thing];
  // Of the side of the rod that is the lower one.
  const double start = dot(plane.normal, rod.from) - rod.radius[0],
               rise = dot(plane.normal, rod.to) - rod.radius[1] - start;
  const double from = start + piece.from * rise, to = start + piece.to * rise;
  const double most = plane.at;
  if ((from > most && to > most) || is_above(plane, piece.thing)) return {};
  Piece part = piece;
  if (to > most) part.to = std::min(part.to, (most - start) / rise);
  if (from > most) part.from = std::max(part.from, (most - start) / rise);
  return part;
}

bool SpacePartition::is_above(const Plane& plane, std::uint32_t thing) const {
  if (triangles_.empty()) return false;
  return std::ranges::all_of(triangles_[thing], [&](const Vec3& p) {
    return dot(plane.normal, p) > plane.at + error(max_norm(p));
  });
}

BoxTree SpacePartition::tree_of(const Cell& cell) const {
  std::vector<Box> boxes;
  std::vector<std::uint32_t> groups;
  std::uint32_t group = 0;
  for (std::size_t i = 0; i < cell.pieces.size(); ++i) {
    const std::uint32_t label = labels_[cell.pieces[i].thing];
    if (i > 0 && label != labels_[cell.pieces[i - 1].thing]) ++group;
    boxes.push_back(box_of(cell.pieces[i]));
    groups.push_back(label == no_label ? BoxTree::no_group : group);
  }
  return BoxTree(boxes, groups);
}

Vec3 SpacePartition::at(const Piece& piece, double share) const {
  const Rod& rod = rods_[piece.thing];
  return rod.from + share * (rod.to - rod.from);
}

Box SpacePartition::box_of(const Piece& piece) const {
  if (!is_certain_) return Box::everything();
  Bounds bounds;
  for (const double share : {piece.from, piece.to}) {
    const Vec3 p = at(piece, share);
    const double radius = rods_[piece.thing].radius_at(share);
    const Vec3 about{radius, radius, radius};
    bounds.add(p - about);
    bounds.add(p + about);
  }
  return bounds.box();
}

}  // namespace sectile
