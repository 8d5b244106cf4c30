#include "rounding/clear_stars.h"

#include <algorithm>

#include "parallel/parallel.h"
#include "rounding/clear_star.h"

namespace sectile {
namespace {

class Stars {
  using Triangles = RoundedTriangles::Triangles;

 public:
  Stars(const RoundedTriangles& mesh, double slack)
      : mesh_(mesh), at_(mesh.positions()), slack_(slack) {}

  std::vector<std::uint8_t> run(const Triangles& of) {
    number_vertices(of);
    find_triangles(of);
    look_at_triangles();
    gather();
    std::vector<std::uint8_t> clear(at_.size(), 0);
    parallel::loop(parallel::Range<std::size_t>(0, vertex_.size(), 256), [&](const auto& range) {
      std::vector<StarTriangle> star;
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        star.clear();
        for (std::uint32_t k = first_[i]; k < first_[i + 1]; ++k)
          star.push_back(
              {facing_[members_[k].triangle], at_[members_[k].first], at_[members_[k].second]});
        clear[vertex_[i]] = is_clear_star(at_[vertex_[i]], star) ? 1 : 0;
      }
    });
    return clear;
  }

 private:
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  struct Member {
    std::uint32_t triangle;       // of those that are looked at
    std::uint32_t first, second;  // its corners after the star's vertex
  };

  void number_vertices(const Triangles& of) {
    number_.assign(at_.size(), none);
    for (const std::uint32_t t : of)
      for (const std::uint32_t v : mesh_.corners(t)) {
        if (number_[v] != none) continue;
        number_[v] = static_cast<std::uint32_t>(vertex_.size());
        vertex_.push_back(v);
      }
  }

  void find_triangles(const Triangles& of) {
    constexpr std::size_t some = 32;  // that come one after another, and so are near each other
    std::vector<Box> boxes((of.size() + some - 1) / some);
    parallel::loop(parallel::Range<std::size_t>(0, boxes.size(), 32), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i)
        for (std::size_t k = some * i; k < std::min(of.size(), some * (i + 1)); ++k) {
          const RoundedTriangles::Corners c = mesh_.corners(of[k]);
          boxes[i].add(box_around({c, {at_[c[0]], at_[c[1]], at_[c[2]]}}, 2 * slack_));
        }
    });
    triangles_ =
        mesh_.with_any(BoxIndex(boxes, true), [&](std::uint32_t v) { return number_[v] != none; });
  }

  void look_at_triangles() {
    facing_.resize(triangles_.size());
    parallel::loop(parallel::Range<std::size_t>(0, facing_.size(), 1024), [&](const auto& range) {
      for (std::size_t i = range.begin(); i < range.end(); ++i) {
        const RoundedTriangles::Corners c = mesh_.corners(triangles_[i]);
        facing_[i] = Facing(PlaneWithSlack(at_[c[0]], at_[c[1]], at_[c[2]], slack_));
      }
    });
  }

  void gather() {
    // Counted two places ahead: filling a star moves its first member to that of the next one.
    first_.assign(vertex_.size() + 2, 0);
    for_each_member([&](std::uint32_t star, const Member&) { ++first_[star + 2]; });
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    members_.resize(first_.back());
    for_each_member([&](std::uint32_t star, const Member& m) { members_[first_[star + 1]++] = m; });
    first_.pop_back();
  }
  template <class Visit>
  void for_each_member(const Visit& visit) const {
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
      const auto [a, b, c] = mesh_.corners(triangles_[i]);
      if (number_[a] != none) visit(number_[a], Member{i, b, c});
      if (number_[b] != none) visit(number_[b], Member{i, c, a});
      if (number_[c] != none) visit(number_[c], Member{i, a, b});
    }
  }

  const RoundedTriangles& mesh_;
  const std::vector<Vec3>& at_;
  const double slack_;
  std::vector<std::uint32_t> vertex_, number_;  // of each star, and of each vertex
  Triangles triangles_;                         // at any of the stars
  std::vector<Facing> facing_;                  // per triangle of those
  std::vector<std::uint32_t> first_;            // per star, and the end
  std::vector<Member> members_;
};

}  // namespace

std::vector<std::uint8_t> clear_stars(const RoundedTriangles& mesh,
                                      const RoundedTriangles::Triangles& of, double slack) {
  return Stars(mesh, slack).run(of);
}

}  // namespace sectile
