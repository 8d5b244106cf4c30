// Words and numbers with spaces between them, section by section, each with the number of its
// entries first. Doubles are hexadecimal. An exact number is a sum of doubles, each with a further
// power of two.
#include "sectile/exact_file.h"

#include <charconv>
#include <istream>
#include <iterator>
#include <ostream>
#include <string>

#include "numbers/none.h"
#include "sectile/errors.h"
#include "storage/solid_data.h"
#include "topology/links.h"

namespace sectile {
namespace {

constexpr std::string_view first_line = "sectile exact 1";
// Hundreds of moves, each with factors at the ends of doubles.
constexpr std::int64_t most_power = 1000000;

class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) {}

  void write(const Block& block) {
    out_ << first_line << '\n';
    const Geometry& g = block.geometry();
    section("frames", g.frames, [&](const auto& frame) {
      for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) number(frame->exact(row, column));
    });
    section("directions", g.directions, [&](const auto& direction) {
      for (const ExactNumber& d : direction->d) number(d.exact());
    });
    section("exact_coefficients", g.exact_coefficients, [&](const auto& plane) {
      for (const ExactNumber& n : plane->n) number(n.exact());
      number(plane->d.exact());
    });
    section("coefficients", g.coefficients, [&](const PlaneCoefficients& p) {
      numbers({p.a, p.b, p.c, p.d});
    });
    section("planes", g.planes, [&](const PlaneDefinition& p) { ids({p.a, p.b, p.c}); });
    begin("points", g.positions.size());
    for (std::uint32_t p = 0; p < g.positions.size(); ++p) point(g, PointId(p));
    write(block.brep());
  }

 private:
  void begin(const char* name, std::size_t count) { out_ << name << ' ' << count << '\n'; }
  template <class Table, class Write>
  void section(const char* name, const Table& table, const Write& write_one) {
    begin(name, table.size());
    for (const auto& entry : table) {
      write_one(entry);
      out_ << '\n';
    }
  }

  void number(double value) {
    char text[40];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::hex).ptr;
    out_ << ' ';
    out_.write(text, end - text);
  }
  void numbers(std::initializer_list<double> values) {
    for (const double v : values) number(v);
  }
  void number(const Dyadic& value) {
    std::vector<std::pair<double, std::int64_t>> parts;
    for (Dyadic rest = value; rest.sign() != Sign::zero;) {
      const std::int64_t power = rest.magnitude();
      const double part = rest.scaled(-power).nearest();
      parts.emplace_back(part, power);
      rest -= Dyadic(part).scaled(power);
    }
    out_ << ' ' << parts.size();
    for (const auto& [part, power] : parts) {
      number(part);
      out_ << ' ' << power;
    }
  }
  void ids(std::initializer_list<std::uint32_t> values) {
    for (const std::uint32_t v : values) out_ << ' ' << v;
  }

  void point(const Geometry& g, PointId p) {
    const Vec3& at = g.position(p);
    if (g.is_constructed(p)) {
      const Construction& how = g.construction(p);
      out_ << "planes";
      ids({how.a.value(), how.b.value(), how.c.value(), how.line_from.value(),
           how.line_to.value()});
    } else if (g.is_moved(p)) {
      const MovedPoint& how = g.moved_point_of(p);
      out_ << "moved";
      ids({how.frame});
      numbers({how.local.x, how.local.y, how.local.z});
    } else {
      out_ << "given";
    }
    numbers({at.x, at.y, at.z});
    out_ << '\n';
  }

  void write(const Brep& brep) {
    begin("vertices", brep.vertex_count());
    for (const PointId p : brep.point) out_ << p.value() << '\n';
    begin("half_edges", brep.half_edge_count());
    for (const VertexId v : brep.origin) out_ << v.value() << '\n';
    begin("edge_planes", brep.edge_plane.size());
    for (const PlaneId s : brep.edge_plane) out_ << s.value() << '\n';
    begin("faces", brep.face_count());
    for (const FaceId f : brep.faces()) {
      ids({brep.plane[f].value(), brep.source[f].solid, brep.source[f].face});
      for (LoopId l = brep.outer_loop[f]; l.valid(); l = brep.next_loop[l]) {
        std::size_t corners = 0;
        for_each_in_loop(brep, l, [&](HalfEdgeId) { ++corners; });
        out_ << ' ' << corners;
        for_each_in_loop(brep, l, [&](HalfEdgeId h) { out_ << ' ' << h.value(); });
      }
      out_ << " 0\n";
    }
  }

  std::ostream& out_;
};

class Reader {
 public:
  Reader(std::string text, std::string_view name)
      : text_(std::move(text)), name_(name), at_(text_.data()), end_(at_ + text_.size()) {}

  Solid read() {
    if (!std::string_view(text_).starts_with(first_line)) fail("is no exact solid");
    at_ += first_line.size();
    auto data = std::make_shared<SolidData>();
    read(data->geometry());
    if (read(data->brep(), data->geometry())) data->origin = data->brep().source[FaceId(0)].solid;
    data->cut();
    return Solid(std::shared_ptr<const SolidData>(std::move(data)));
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw FileError(name_ + ": " + what); }

  std::string_view word() {
    while (at_ < end_ && (*at_ == ' ' || *at_ == '\n' || *at_ == '\r')) ++at_;
    const char* const begin = at_;
    while (at_ < end_ && *at_ != ' ' && *at_ != '\n' && *at_ != '\r') ++at_;
    return {begin, static_cast<std::size_t>(at_ - begin)};
  }
  template <class Value, class... Format>
  Value value(Format... format) {
    const std::string_view text = word();
    Value result{};
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, result, format...);
    if (error != std::errc() || stop != end)
      fail("a number is expected, not \"" + std::string(text) + "\"");
    return result;
  }
  std::uint32_t id() { return value<std::uint32_t>(); }
  std::uint32_t id(std::size_t count, bool may_be_none = false) {
    const std::uint32_t i = id();
    if (i >= count && !(may_be_none && i == none)) fail("there is no " + std::to_string(i));
    return i;
  }
  double number() {
    const double x = value<double>(std::chars_format::hex);
    if (x - x != 0) fail("a number is not finite");
    return x;
  }
  // Positions that are rounded are infinite where doubles end.
  double rounded() { return value<double>(std::chars_format::hex); }
  Dyadic exact() {
    Dyadic sum;
    for (std::uint32_t parts = id(); parts > 0; --parts) {
      const double part = number();
      const auto power = value<std::int64_t>();
      if (power < -most_power || power > most_power) fail("a number is out of all reason");
      sum += Dyadic(part).scaled(power);
    }
    return sum;
  }
  Vec3 vector() {
    const double x = number(), y = number();
    return {x, y, number()};
  }
  Vec3 rounded_vector() {
    const double x = rounded(), y = rounded();
    return {x, y, rounded()};
  }

  // Each entry takes two bytes, so no file can claim more memory than it is worth.
  std::uint32_t begin(std::string_view name) {
    if (word() != name) fail("the section " + std::string(name) + " is expected");
    const std::uint32_t count = id();
    if (count > text_.size() / 2) fail("a section is longer than the file");
    return count;
  }

  void read(Geometry& g) {
    for (std::uint32_t n = begin("frames"); n > 0; --n) {
      std::array<Dyadic, 12> entries;
      for (Dyadic& e : entries) e = exact();
      g.frames.place(std::make_shared<const Frame>(entries));
    }
    for (std::uint32_t n = begin("directions"); n > 0; --n) {
      ExactDirection direction;
      for (ExactNumber& d : direction.d) d = ExactNumber(exact());
      g.directions.place(std::make_shared<const ExactDirection>(std::move(direction)));
    }
    for (std::uint32_t n = begin("exact_coefficients"); n > 0; --n) {
      ExactCoefficients plane;
      for (ExactNumber& d : plane.n) d = ExactNumber(exact());
      plane.d = ExactNumber(exact());
      g.exact_coefficients.push_back(std::make_shared<const ExactCoefficients>(std::move(plane)));
    }
    for (std::uint32_t n = begin("coefficients"); n > 0; --n) {
      const Vec3 normal = vector();
      g.coefficients.push_back({normal.x, normal.y, normal.z, number()});
    }
    for (std::uint32_t n = begin("planes"); n > 0; --n) {
      const std::uint32_t a = id(), b = id();
      g.planes.add({a, b, id()});
    }
    const std::uint32_t points = begin("points");
    for (std::uint32_t n = 0; n < points; ++n) read_point(g, points);
    for (const PlaneDefinition& plane : g.planes) check(g, plane);
    for (std::uint32_t p = 0; p < points; ++p)
      if (g.is_constructed(PointId(p))) check(g, g.construction(PointId(p)));
  }

  void read_point(Geometry& g, std::uint32_t points) {
    const std::string_view how = word();
    if (how == "given") {
      g.add_point(vector());
    } else if (how == "moved") {
      const std::uint32_t frame = id(g.frames.size());
      const Vec3 local = vector();
      g.add_point(MovedPoint{local, frame}, rounded_vector());
    } else if (how == "planes") {
      Construction c;
      for (PlaneId* s : {&c.a, &c.b, &c.c}) *s = PlaneId(id(g.planes.size()));
      for (PointId* p : {&c.line_from, &c.line_to}) *p = PointId(id(points, true));
      g.add_point(c, rounded_vector());
    } else {
      fail("\"" + std::string(how) + "\" is no kind of point");
    }
  }

  void check(const Geometry& g, const PlaneDefinition& plane) const {
    using Kind = PlaneDefinition::Kind;
    const auto require = [&](bool good) {
      if (!good) fail("a plane is made of what does not exist");
    };
    if (plane.kind() == Kind::coefficients) return require(plane.a < g.coefficients.size());
    if (plane.kind() == Kind::exact_coefficients)
      return require(plane.a < g.exact_coefficients.size());
    // Not constructed ones, which are made of planes: nothing may be made of itself.
    const auto is_given = [&](std::uint32_t p) {
      return p < g.positions.size() && !g.is_constructed(PointId(p));
    };
    require(is_given(plane.a) && is_given(plane.b));
    if (plane.kind() == Kind::three_points) require(is_given(plane.c));
    if (plane.kind() == Kind::along_direction) require(plane.direction() < g.directions.size());
  }

  void check(const Geometry& g, const Construction& how) const {
    for (const PointId p : {how.line_from, how.line_to})
      if (p.valid() && g.is_constructed(p)) fail("a line does not run between given points");
  }

  // Returns whether there are any faces.
  bool read(Brep& brep, const Geometry& g) {
    for (std::uint32_t n = begin("vertices"); n > 0; --n)
      brep.point.add(PointId(id(g.positions.size())));
    const std::uint32_t half_edges = begin("half_edges");
    if (half_edges % 2 != 0) fail("half-edges come in pairs");
    for (std::uint32_t n = half_edges; n > 0; --n)
      brep.origin.add(VertexId(id(brep.vertex_count())));
    const std::uint32_t pins = begin("edge_planes");
    if (pins != 0 && pins != half_edges / 2) fail("not all edges have a plane or none");
    for (std::uint32_t n = pins; n > 0; --n)
      brep.edge_plane.add(PlaneId(id(g.planes.size(), true)));
    brep.resize_half_edges(half_edges);
    brep.vertex_half_edge.resize(brep.vertex_count());
    for (const HalfEdgeId h : brep.half_edges()) brep.vertex_half_edge[brep.from(h)] = h;
    for (std::uint32_t n = begin("faces"); n > 0; --n) read_face(brep, g);
    for (const auto* links : {&brep.next, &brep.prev})
      for (const HalfEdgeId h : *links)
        if (!h.valid()) fail("a half-edge is in no loop");
    for (const HalfEdgeId h : brep.vertex_half_edge)
      if (!h.valid()) fail("a vertex has no half-edge");
    if (const auto broken = broken_links(brep, false); !broken.empty()) fail(broken.front());
    return brep.face_count() > 0;
  }

  void read_face(Brep& brep, const Geometry& g) {
    const PlaneId plane(id(g.planes.size()));
    const std::uint32_t solid = id();
    const FaceId face = brep.add_face(plane, {solid, id()}, LoopId(brep.loop_count()));
    for (std::uint32_t corners = id(), first = corners; corners > 0; corners = id(), first = 0) {
      if (first == 0) brep.next_loop.back() = LoopId(brep.loop_count());
      read_loop(brep, face, corners);
    }
    if (brep.outer_loop.back().value() == brep.loop_count()) fail("a face has no loop");
  }

  void read_loop(Brep& brep, FaceId face, std::uint32_t corners) {
    const HalfEdgeId begin(id(brep.half_edge_count()));
    const LoopId loop = brep.add_loop(face, begin);
    HalfEdgeId last = begin;
    for (std::uint32_t k = 0; k < corners; ++k) {
      if (brep.loop[last].valid()) fail("a half-edge is in two loops");
      brep.loop[last] = loop;
      const HalfEdgeId next = k + 1 < corners ? HalfEdgeId(id(brep.half_edge_count())) : begin;
      brep.next[last] = next;
      brep.prev[next] = last;
      last = next;
    }
  }

  std::string text_, name_;
  const char *at_, *end_;
};

}  // namespace

void write_exact(std::ostream& out, const Solid& solid) {
  const Block nothing;
  Writer(out).write(solid.is_empty() ? nothing : solid.data()->whole());
}

Solid read_exact(std::istream& in, std::string_view name) {
  return Reader(std::string(std::istreambuf_iterator<char>(in), {}), std::string(name)).read();
}

}  // namespace sectile
