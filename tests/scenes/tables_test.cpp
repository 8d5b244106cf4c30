// Tables I, II and III and the ties of figures 19 and 20, row by row: around one line, all wedges
// of material between two of eight directions, of A against those of B and against B's face. Each
// half-plane's class is asked for in the trace and compared with what the angles say; what becomes
// of the ON classes is compared with Table I as docs/paper.md corrects it, written down here again.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "sectile/sectile.h"

namespace sectile {
namespace {

// Material reaches counter-clockwise from one direction to the other; direction k is at 45k
// degrees.
struct Wedge {
  int from, to;
  int width() const { return (to - from + 8) % 8; }
  /// Strictly between.
  bool has(int k) const {
    const int turn = (k - from + 8) % 8;
    return 0 < turn && turn < width();
  }
};

std::vector<Wedge> all_wedges() {
  std::vector<Wedge> wedges;
  for (int from = 0; from < 8; ++from)
    for (int to = 0; to < 8; ++to)
      if (from != to) wedges.push_back({from, to});
  return wedges;
}

Vec2 corner(int k, double size) {
  constexpr int x[] = {1, 1, 0, -1, -1, -1, 0, 1};
  return {size * x[k % 8], size * x[(k + 6) % 8]};
}

// Half-planes between two faces of one plane are asked for, too: each face stays as it is.
Solid with_each_face(const PolygonMesh& mesh) {
  std::vector<std::uint32_t> each(mesh.face_sizes.size());
  std::iota(each.begin(), each.end(), 0u);
  ImportOptions options;
  options.face_groups = each;
  return Solid::from_mesh(mesh, options);
}

Solid solid_of(const Wedge& wedge, double size, double low, double high) {
  std::vector<Vec2> outline{{0, 0}};
  for (int k = 0; k <= wedge.width(); ++k) outline.push_back(corner(wedge.from + k, size));
  const auto n = static_cast<std::uint32_t>(outline.size());
  PolygonMesh mesh;
  for (const double z : {low, high})
    for (const Vec2& p : outline) mesh.positions.push_back({p.x, p.y, z});
  mesh.face_sizes = {n, n};
  for (std::uint32_t i = n; i-- > 0;) mesh.indices.push_back(i);
  for (std::uint32_t i = 0; i < n; ++i) mesh.indices.push_back(n + i);
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n;
    mesh.face_sizes.push_back(4);
    mesh.indices.insert(mesh.indices.end(), {i, j, n + j, n + i});
  }
  return with_each_face(mesh);
}
Solid thin(const Wedge& wedge) {
  return solid_of(wedge, 4, 0, 1);
}
Solid thick(const Wedge& wedge) {
  return solid_of(wedge, 5, -1, 2);
}
// The lower half, whose face holds the line; as a wedge it reaches from 4 to 0.
constexpr Wedge lower_half{4, 0};
Solid thick_face() {
  return block({-8, -8, -1}, {8, 0, 2});
}

class Neighborhoods : public Observer {
 public:
  std::vector<NeighborhoodEvent> events;
  void phase_done(Phase phase, const std::vector<TraceEvent>& found) override {
    if (phase != Phase::vertex_face && phase != Phase::vertex_vertex) return;
    for (const TraceEvent& event : found) events.push_back(std::get<NeighborhoodEvent>(event));
  }
};

bool is_on_line(const NeighborhoodEvent& event) {
  for (const TracePlace& end : event.ends)
    if (end.point.x != 0 || end.point.y != 0) return false;
  return true;
}

// The one neighborhood along the line of both wedges' edges.
NeighborhoodEvent around_line(const Solid& a, const Solid& b, Operation operation) {
  Neighborhoods found;
  BooleanOptions options;
  options.validate = true;
  options.observer = &found;
  EXPECT_TRUE(validate(boolean(a, b, operation, options)).empty());
  std::erase_if(found.events, [](const NeighborhoodEvent& event) { return !is_on_line(event); });
  EXPECT_EQ(found.events.size(), 1u);
  return found.events.empty() ? NeighborhoodEvent{} : found.events.front();
}

int direction_of(const TraceHalfPlane& h) {
  return (static_cast<int>(std::lround(std::atan2(h.direction.y, h.direction.x) * 4 / M_PI)) + 8) %
         8;
}
// Material lies counter-clockwise of the half-plane.
bool starts(const TraceHalfPlane& h) {
  return h.direction.x * h.normal.y - h.direction.y * h.normal.x < 0;
}

TraceClass class_by_angle(int k, bool starts_material, const Wedge& other) {
  if (k == other.from) return starts_material ? TraceClass::on_plus : TraceClass::on_minus;
  if (k == other.to) return starts_material ? TraceClass::on_minus : TraceClass::on_plus;
  return other.has(k) ? TraceClass::in : TraceClass::out;
}

// Table I, corrected.
TraceClass reclassified(TraceClass before, int solid, Operation operation) {
  if (!is_on(before)) return before;
  const bool own = solid == 0 && before == TraceClass::on_plus;
  return own == (operation == Operation::unite) ? TraceClass::out : TraceClass::in;
}

// Equation (4).
bool is_kept(TraceClass after, int solid, Operation operation) {
  if (operation == Operation::unite) return after == TraceClass::out;
  if (operation == Operation::intersect) return after == TraceClass::in;
  return after == (solid == 0 ? TraceClass::out : TraceClass::in);
}

constexpr Operation operations[] = {Operation::unite, Operation::intersect, Operation::subtract};

bool combined(bool a, bool b, Operation operation) {
  return operation == Operation::unite       ? a || b
         : operation == Operation::intersect ? a && b
                                             : a && !b;
}

void expect_half_planes(const NeighborhoodEvent& event, const Wedge (&wedges)[2],
                        Operation operation) {
  std::set<std::pair<int, int>> seen;
  for (const TraceHalfPlane& h : event.half_planes) {
    const int k = direction_of(h);
    seen.insert({h.solid, k});
    const Wedge &own = wedges[h.solid], &other = wedges[1 - h.solid];
    EXPECT_EQ(k, starts(h) ? own.from : own.to);
    const TraceClass before = class_by_angle(k, starts(h), other),
                     after = reclassified(before, h.solid, operation);
    EXPECT_EQ(h.before, before) << "solid " << int(h.solid) << " direction " << k;
    EXPECT_EQ(h.after, after) << "solid " << int(h.solid) << " direction " << k;
    EXPECT_EQ(h.kept, is_kept(after, h.solid, operation));
    EXPECT_EQ(h.coplanar >= 0, is_on(before));
  }
  EXPECT_EQ(seen.size(), 4u);
  // What is kept in a direction is one half-plane if the result begins or ends there, else none.
  for (int k = 0; k < 8; ++k) {
    const auto material = [&](int eighth) {
      const auto in = [&](const Wedge& w) { return (eighth - w.from + 8) % 8 < w.width(); };
      return combined(in(wedges[0]), in(wedges[1]), operation);
    };
    const auto kept =
        std::count_if(event.half_planes.begin(), event.half_planes.end(),
                      [&](const TraceHalfPlane& h) { return h.kept && direction_of(h) == k; });
    EXPECT_EQ(kept, material(k) != material((k + 7) % 8) ? 1 : 0) << "direction " << k;
  }
}

std::string name(const Wedge& a, const Wedge& b, Operation operation) {
  return std::to_string(a.from) + ".." + std::to_string(a.to) + " with " + std::to_string(b.from) +
         ".." + std::to_string(b.to) + ", operation " + std::to_string(static_cast<int>(operation));
}

// The row of Table II that the two sectors beside an edge have against a face, seen from the end at
// which `first` comes first.
int row_of_table_2(TraceClass first, TraceClass second) {
  const auto column = [](TraceClass c) { return is_on(c) ? 0 : c == TraceClass::in ? 1 : 2; };
  return 3 * column(first) + column(second) + 1;
}

TEST(Tables, EveryEdgeOfAInAFaceOfBAndTheOtherWayRound) {
  std::set<int> rows;
  std::set<std::string> rows_of_table_3;
  for (const bool turned : {false, true})
    for (const Wedge& wedge : all_wedges()) {
      const Wedge wedges[2] = {turned ? lower_half : wedge, turned ? wedge : lower_half};
      const Solid a = turned ? thick_face() : thin(wedge), b = turned ? thin(wedge) : thick_face();
      for (const Operation operation : operations) {
        SCOPED_TRACE(name(wedges[0], wedges[1], operation));
        const NeighborhoodEvent event = around_line(a, b, operation);
        expect_half_planes(event, wedges, operation);
        const TraceClass first = class_by_angle(wedge.from, true, lower_half),
                         second = class_by_angle(wedge.to, false, lower_half);
        const int row = row_of_table_2(first, second), back = row_of_table_2(second, first);
        rows.insert(row);
        const PaperRule rule = paper_rule(event, operation);
        EXPECT_TRUE(rule.where.find("row " + std::to_string(row)) != std::string::npos &&
                    rule.where.find("row " + std::to_string(back)) != std::string::npos)
            << rule.where;
        if (const auto table_3 = rule.where.find("Table III"); table_3 != std::string::npos)
          rows_of_table_3.insert(rule.where.substr(table_3));
      }
    }
  EXPECT_EQ(rows, (std::set<int>{1, 2, 3, 4, 5, 6, 7, 8, 9}));
  EXPECT_EQ(rows_of_table_3,
            (std::set<std::string>{"Table III (identical, A against B, ∪: the rule holds)",
                                   "Table III (identical, A against B, ∩: the rule does not hold)",
                                   "Table III (identical, A against B, \\: the rule does not hold)",
                                   "Table III (identical, B against A, ∪: the rule does not hold)",
                                   "Table III (identical, B against A, ∩: the rule holds)",
                                   "Table III (identical, B against A, \\: the rule holds)",
                                   "Table III (opposite, A against B, ∪: the rule does not hold)",
                                   "Table III (opposite, A against B, ∩: the rule holds)",
                                   "Table III (opposite, A against B, \\: the rule holds)",
                                   "Table III (opposite, B against A, ∪: the rule does not hold)",
                                   "Table III (opposite, B against A, ∩: the rule holds)",
                                   "Table III (opposite, B against A, \\: the rule holds)"}));
}

TEST(Tables, EveryEdgeOfAOnAnEdgeOfB) {
  std::map<std::string, int> figures;
  const auto wedges_of_a = all_wedges(), wedges_of_b = all_wedges();
  std::vector<Solid> thick_wedges;
  for (const Wedge& b : wedges_of_b) thick_wedges.push_back(thick(b));
  for (const Wedge& a : wedges_of_a) {
    const Solid solid = thin(a);
    for (std::size_t i = 0; i < wedges_of_b.size(); ++i)
      for (const Operation operation : operations) {
        const Wedge wedges[2] = {a, wedges_of_b[i]};
        SCOPED_TRACE(name(wedges[0], wedges[1], operation));
        const NeighborhoodEvent event = around_line(solid, thick_wedges[i], operation);
        expect_half_planes(event, wedges, operation);
        ++figures[paper_rule(event, operation).where];
        if (HasFailure()) return;
      }
  }
  for (const char* figure : {"figure 19a", "figure 19b", "figure 20a", "figure 20b", "figure 20c",
                             "figure 20d", "figure 20e"})
    EXPECT_GT(figures[figure], 0) << figure;
  EXPECT_EQ(figures.size(), 7u);
}

}  // namespace
}  // namespace sectile
