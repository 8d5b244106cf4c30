#include "import/nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>

#include "geometry/face_predicates.h"
#include "geometry/triangulation.h"
#include "import/faces_along_x.h"
#include "import/shell_boxes.h"
#include "numbers/threshold.h"
#include "search/face_tree.h"
#include "search/missed_face.h"
#include "sectile/errors.h"

namespace sectile {
namespace {

// A line along the x axis through a point within a face, near to its farthest corner. The points
// are those of a parabola in a triangle: a line of the projection along x contains at most two of
// them, so there is always one that lies beside all edges. `counts` tells which of the other faces
// are looked at.
template <class Counts>
class LineThroughFace {
 public:
  LineThroughFace(const SolidData& data, const Kernel& kernel, const FacesAlongX& others,
                  FaceId face, const Counts& counts)
      : data_(data),
        kernel_(kernel),
        others_(others),
        face_(face),
        counts_(counts),
        triangle_(farthest_triangle()) {}

  /// The faces on the line beyond this one, along the x axis, up to one of which something is known
  /// already.
  template <class IsKnown>
  std::vector<FaceId> faces_beyond(const IsKnown& is_known) {
    for (int n = 1024;; n *= 2)
      for (int odd = n - 1; odd > n / 2; odd -= 2) {
        choose_point(odd, n);
        if (auto faces = follow(is_known)) return *std::move(faces);
      }
  }

 private:
  // With the farthest corner last.
  std::array<PointId, 3> farthest_triangle() const {
    std::vector<PointId> corners;
    std::vector<std::uint32_t> loop_ends;
    const Brep& brep = data_.brep();
    for (LoopId l = brep.outer_loop[face_]; l.valid(); l = brep.next_loop[l]) {
      for_each_in_loop(brep, l,
                       [&](HalfEdgeId h) { corners.push_back(brep.point_of(brep.from(h))); });
      loop_ends.push_back(static_cast<std::uint32_t>(corners.size()));
    }
    const PlaneId plane = brep.plane[face_];
    const int axis = kernel_.main_axis(plane);
    const FacePredicates exact(kernel_, axis, kernel_.normal(plane, axis) == Sign::negative,
                               corners);
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangulate(exact, std::span<const std::uint32_t>(loop_ends), triangles);
    const auto x = [&](std::uint32_t c) { return data_.geometry().position(corners[c]).x; };
    std::array<std::uint32_t, 3> farthest = triangles.front();
    for (std::array<std::uint32_t, 3> t : triangles) {
      std::rotate(
          t.begin(),
          std::max_element(t.begin(), t.end(), [&](auto c, auto d) { return x(c) < x(d); }) + 1,
          t.end());
      if (x(t[2]) >= x(farthest[2])) farthest = t;
    }
    return {corners[farthest[0]], corners[farthest[1]], corners[farthest[2]]};
  }

  // The parabola's point at the parameter k / n, with the weight n².
  void choose_point(int k, int n) {
    const double weights[3] = {double(n - k) * (n - k), 2.0 * k * (n - k), double(k) * k};
    const ExactPoint* const corners[] = {&kernel_.exact(triangle_[0]), &kernel_.exact(triangle_[1]),
                                         &kernel_.exact(triangle_[2])};
    point_ = {{Dyadic(), Dyadic(), Dyadic()},
              Dyadic(double(n) * n) * corners[0]->w * corners[1]->w * corners[2]->w};
    for (std::size_t i = 0; i < 3; ++i) {
      const Dyadic share = Dyadic(weights[i]) * corners[(i + 1) % 3]->w * corners[(i + 2) % 3]->w;
      for (int axis = 0; axis < 3; ++axis) point_.x[axis] += share * corners[i]->x[axis];
    }
    if (point_.w.sign() == Sign::negative) {
      for (Dyadic& x : point_.x) x = -x;
      point_.w = -point_.w;
    }
    near_ = {0, nearest_quotient(point_.x[1], point_.w), nearest_quotient(point_.x[2], point_.w)};
    line_.low_y = below(near_.y);
    line_.high_y = above(near_.y);
    line_.low_z = below(near_.z);
    line_.high_z = above(near_.z);
  }

  // The faces on the line, from the first one on along the x axis, up to one of a shell that is
  // known. Nothing if the line meets an edge. As a rule, there are few; many are put in order at
  // once, as each step takes a look at all that is beyond.
  template <class IsKnown>
  std::optional<std::vector<FaceId>> follow(const IsKnown& is_known) {
    constexpr std::size_t few = threshold(8, 1);
    std::vector<FaceId> faces;
    at_ = {point_.x[0], point_.w};
    while (faces.empty() || !is_known(faces.back())) {
      if (faces.size() == few) {
        const auto rest = all_after(faces.back());
        if (!rest) return {};
        const auto known = std::find_if(rest->begin(), rest->end(), is_known);
        faces.insert(faces.end(), rest->begin(), known == rest->end() ? known : known + 1);
        break;
      }
      const std::optional<FaceId> next = next_after(faces.empty() ? face_ : faces.back());
      if (!next) return {};
      if (!next->valid()) break;
      faces.push_back(*next);
    }
    return faces;
  }

  struct Place {
    Dyadic numerator, denominator;
    Sign compare(const Place& other) const {
      return (other.numerator * denominator - numerator * other.denominator).sign();
    }
    double nearest() const { return nearest_quotient(numerator, denominator); }
  };

  // The first face beyond `from`, which is at at_, and goes there; an invalid id behind the last
  // one. Nothing if the line meets an edge on its way, or two faces at one place.
  std::optional<FaceId> next_after(FaceId from) {
    FaceId next;
    Place place;
    StretchAlongX stretch = beyond_here();
    const bool is_clear = for_each_beyond(from, stretch, [&](FaceId f, Place&& here) {
      const Sign order = next.valid() ? here.compare(place) : Sign::positive;
      if (order == Sign::zero) refuse_if_flush(next, f);
      if (order == Sign::positive) {
        next = f;
        place = std::move(here);
        stretch.end = above(place.nearest());
      }
      return order != Sign::zero;
    });
    if (!is_clear) return {};
    at_ = std::move(place);
    return next;
  }

  // All faces beyond `from`, which is at at_, in their order. Nothing as with next_after.
  std::optional<std::vector<FaceId>> all_after(FaceId from) const {
    struct Met {
      FaceId face;
      Place place;
    };
    std::vector<Met> all;
    StretchAlongX stretch = beyond_here();
    const bool is_clear = for_each_beyond(from, stretch, [&](FaceId f, Place&& here) {
      all.push_back({f, std::move(here)});
      return true;
    });
    if (!is_clear) return {};
    std::sort(all.begin(), all.end(), [](const Met& a, const Met& b) {
      return a.place.compare(b.place) == Sign::positive;
    });
    std::vector<FaceId> faces;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i > 0 && all[i - 1].place.compare(all[i].place) == Sign::zero) {
        refuse_if_flush(all[i - 1].face, all[i].face);
        return {};
      }
      faces.push_back(all[i].face);
    }
    return faces;
  }

  StretchAlongX beyond_here() const {
    StretchAlongX stretch = line_;
    stretch.begin = below(at_.nearest());
    stretch.end = std::numeric_limits<double>::infinity();
    return stretch;
  }

  // Calls visit(face, place) for the faces beyond `from`, which is at at_, until it returns false.
  // False then, and if the line meets an edge, or another face at at_.
  template <class Visit>
  bool for_each_beyond(FaceId from, StretchAlongX& stretch, const Visit& visit) const {
    bool is_clear = true;
    const auto meet = [&](FaceId f) {
      const std::optional<bool> met = meets(f);
      if (!met) return false;
      if (!*met) return true;
      Place here = place_on(f);
      const Sign beyond = at_.compare(here);
      if (beyond == Sign::zero) refuse_if_flush(from, f);
      return beyond == Sign::negative || (beyond == Sign::positive && visit(f, std::move(here)));
    };
    others_.query(stretch, [&](FaceId f) {
      if (f == from || !is_clear || !counts_(f)) return;
      if (is_missed(data_.brep(), data_.geometry(), f, near_)) return;
      is_clear = meet(f);
      if (!is_clear) stretch.end = -std::numeric_limits<double>::infinity();
    });
    return is_clear;
  }

  Place place_on(FaceId f) const {
    const ExactPlane& s = kernel_.exact(data_.brep().plane[f]);
    const Dyadic rest = s.n[1] * point_.x[1] + s.n[2] * point_.x[2] + s.d * point_.w;
    const bool positive = s.n[0].sign() == Sign::positive;
    return {positive ? -rest : rest, (positive ? s.n[0] : -s.n[0]) * point_.w};
  }

  static double below(double x) {
    return std::nextafter(x, -std::numeric_limits<double>::infinity());
  }
  static double above(double x) {
    return std::nextafter(x, std::numeric_limits<double>::infinity());
  }

  // The sign of the line's distance from a point along the y axis.
  Sign side_in_y(const ExactPoint& p) const {
    return (point_.x[1] * p.w - p.x[1] * point_.w).sign() * p.w.sign();
  }

  // Does the line go through the face? Nothing if it meets an edge of it.
  std::optional<bool> meets(FaceId f) const {
    bool odd = false, on_edge = false;
    for_each_in_face(data_.brep(), f, [&](HalfEdgeId h) {
      const PointId u = data_.brep().point_of(data_.brep().from(h)),
                    v = data_.brep().point_of(data_.brep().to(h));
      const ExactPoint &from = kernel_.exact(u), &to = kernel_.exact(v);
      const Sign side_u = side_in_y(from), side_v = side_in_y(to);
      if (side_u == Sign::zero || side_v == Sign::zero) on_edge = true;
      if (side_u == side_v || on_edge) return;
      const Sign turn = turn_of(from, to, point_, 0).sign() * from.w.sign() * to.w.sign();
      if (turn == Sign::zero) on_edge = true;
      if ((turn == Sign::positive) == (side_u == Sign::negative)) odd = !odd;
    });
    if (on_edge) return {};
    return odd;
  }

  void refuse_if_flush(FaceId one, FaceId other) const {
    if (!kernel_.parallel(data_.brep().plane[one], data_.brep().plane[other])) return;
    const std::uint32_t f = data_.brep().source[one].face, g = data_.brep().source[other].face;
    throw InvalidSolid(InvalidSolid::Reason::self_intersecting,
                       "faces " + std::to_string(f) + " and " + std::to_string(g) +
                           " lie on each other; remove them where they do, or make two solids and "
                           "unite them",
                       f);
  }

  const SolidData& data_;
  const Kernel& kernel_;
  const FacesAlongX& others_;
  FaceId face_;
  const Counts& counts_;
  std::array<PointId, 3> triangle_;
  ExactPoint point_;
  Vec3 near_;           // on the line, rounded
  StretchAlongX line_;  // around all of it
  Place at_;            // how far the line was followed
};

// The layers of material on a line change at its faces, and at infinity there are none. Shells do
// not cross each other: of what is around one, all boxes hold its own, and other shells take away
// from a line what they add to it. So most shells need no line, and no line is followed beyond the
// first face of a shell of which all is known. Those that reach farthest are looked at first, so
// that all is known of what lies beyond the others.
class Surroundings {
 public:
  Surroundings(const SolidData& data, const Kernel& kernel, const Shells& shells)
      : data_(data),
        kernel_(kernel),
        shells_(shells),
        members_(shells.count),
        found_(shells.count),
        known_(shells.count, 0),
        boxes_(shell_boxes(), [&](std::uint32_t s) { return corners(s); }),
        outer_(data, faces_around_others(), boxes_.held_count()) {}

  std::vector<ShellSurroundings> run() {
    for (const std::uint32_t s : boxes_.farthest_first()) {
      found_[s].material = own_layers(s) + (boxes_.is_held(s) ? layers_around(s) : 0);
      known_[s] = 1;
    }
    return std::move(found_);
  }

 private:
  std::uint32_t shell(FaceId f) const { return shells_.of_face[f.value()]; }
  Sign normal(FaceId f) const { return kernel_.normal(data_.brep().plane[f], 0); }

  // Finds the members, too, and of those of each shell that are not parallel to the line one that
  // reaches farthest.
  std::vector<Box> shell_boxes() {
    std::vector<Box> boxes(shells_.count);
    std::vector<float> farthest(shells_.count, -std::numeric_limits<float>::infinity());
    for (std::uint32_t i = 0; i < shells_.of_face.size(); ++i) {
      const FaceId f(i);
      const Box box = face_box(data_.brep(), data_.geometry(), f);
      const std::uint32_t s = shell(f);
      boxes[s].add(box);
      members_[s].push_back(f);
      if (box.high[0] <= farthest[s] || normal(f) == Sign::zero) continue;
      farthest[s] = box.high[0];
      found_[s].face = f;
    }
    for (const ShellSurroundings& s : found_)
      if (!s.face.valid()) throw InternalError("a shell has no extent in the plane across an axis");
    return boxes;
  }

  std::vector<Vec3> corners(std::uint32_t s) const {
    const Brep& brep = data_.brep();
    std::vector<Vec3> corners;
    for (const FaceId f : members_[s])
      for_each_in_loop(brep, brep.outer_loop[f], [&](HalfEdgeId h) {
        corners.push_back(data_.geometry().position(brep.point_of(brep.from(h))));
      });
    return corners;
  }

  std::vector<FaceId> faces_around_others() const {
    std::vector<FaceId> faces;
    for (std::uint32_t s = 0; s < shells_.count; ++s)
      if (boxes_.holds_any(s)) faces.insert(faces.end(), members_[s].begin(), members_[s].end());
    return faces;
  }

  // Those of a shell itself, on its outer side: none, or less than none if it is turned inwards.
  int own_layers(std::uint32_t s) const {
    const FacesAlongX own(data_, members_[s], 1);
    const auto all = [](FaceId) { return true; };
    LineThroughFace line(data_, kernel_, own, found_[s].face, all);
    const int beyond = layers_before(line.faces_beyond([](FaceId) { return false; }));
    return normal(found_[s].face) == Sign::positive ? beyond : beyond - 1;
  }

  // Those of other shells.
  int layers_around(std::uint32_t s) const {
    const auto is_other = [&](FaceId f) { return shell(f) != s; };
    LineThroughFace line(data_, kernel_, outer_, found_[s].face, is_other);
    return layers_before(line.faces_beyond([&](FaceId f) { return known_[shell(f)] != 0; }));
  }

  // Before the first of the faces on a line; beyond the last there are none, or it is known.
  int layers_before(const std::vector<FaceId>& faces) const {
    int layers = 0;
    for (std::size_t i = faces.size(); i-- > 0;) {
      const std::uint32_t s = shell(faces[i]);
      const bool leaves = normal(faces[i]) == Sign::positive;
      if (known_[s] != 0)
        layers = found_[s].material + (leaves ? 1 : 0);
      else
        layers += leaves ? 1 : -1;
    }
    return layers;
  }

  const SolidData& data_;
  const Kernel& kernel_;
  const Shells& shells_;
  std::vector<std::vector<FaceId>> members_;  // per shell
  std::vector<ShellSurroundings> found_;      // per shell
  std::vector<std::uint8_t> known_;
  ShellBoxes boxes_;
  FacesAlongX outer_;
};

}  // namespace

std::vector<ShellSurroundings> shell_surroundings(const SolidData& data, const Kernel& kernel,
                                                  const Shells& shells) {
  return Surroundings(data, kernel, shells).run();
}

}  // namespace sectile
