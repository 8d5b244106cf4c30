#include "sectile/validate.h"

#include <algorithm>

#include "boolean/face_parts.h"
#include "import/contacts.h"
#include "import/nesting.h"
#include "import/shells.h"
#include "topology/links.h"

namespace sectile {
namespace {

class Validator {
 public:
  explicit Validator(const SolidData& data)
      : data_(data), brep_(data.brep()), kernel_(data.geometry()) {}

  std::vector<Violation> run(bool geometry) {
    for (const std::string& what : broken_links(brep_, false)) found_.push_back({what, {}});
    if (!found_.empty()) return std::move(found_);
    check_edges();
    check_loops();
    if (geometry && found_.empty()) check_against_itself();
    if (geometry && found_.empty()) check_nesting();
    return std::move(found_);
  }

 private:
  const Vec3& position(HalfEdgeId h) const {
    return data_.geometry().position(brep_.point_of(brep_.from(h)));
  }
  template <class Id>
  void report(Id id, const std::string& what, const Vec3& where) {
    std::string name(1, IdTag<Id>::letter);
    found_.push_back({name + std::to_string(id.value()) + ": " + what, where});
  }
  template <class Id>
  struct IdTag;
  template <class Tag>
  struct IdTag<Id<Tag>> {
    static constexpr char letter = Tag::letter;
  };

  void check_edges() {
    for (std::size_t i = 0; i < brep_.half_edge_count(); ++i) {
      const HalfEdgeId h{i};
      const PointId from = brep_.point_of(brep_.from(h)), to = brep_.point_of(brep_.to(h));
      if (kernel_.same_point(from, to)) report(Brep::edge_of(h), "has no length", position(h));
      if (kernel_.side(from, brep_.plane_of(h)) != Sign::zero)
        report(brep_.face_of(h), "a corner is not in its plane", position(h));
    }
  }

  void check_loops() {
    std::vector<PointId> points;
    for (std::size_t f = 0; f < brep_.face_count(); ++f)
      for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l.value()]) {
        points.clear();
        for_each_in_loop(brep_, l,
                         [&](HalfEdgeId h) { points.push_back(brep_.point_of(brep_.from(h))); });
        const bool outer = l == brep_.outer_loop[f];
        const bool left =
            points.size() > 2 && is_counter_clockwise(kernel_, brep_.plane[f], points);
        if (left != outer)
          report(FaceId(f),
                 outer ? "its outer loop is clockwise" : "an inner loop is counter-clockwise",
                 position(brep_.loop_half_edge[l.value()]));
      }
  }

  void check_against_itself() {
    for (const FacePairContact& c : face_contacts(brep_, kernel_)) {
      report(c.first, "and f" + std::to_string(c.second.value()) + " " + in_words(c.kind), c.where);
    }
  }

  // Around each shell there is no material.
  void check_nesting() {
    const Shells shells = find_shells(brep_);
    std::vector<std::uint8_t> seen(shells.count, 0);
    for (std::uint32_t f = 0; f < brep_.face_count(); ++f) {
      const std::uint32_t shell = shells.of_face[f];
      if (seen[shell]) continue;
      seen[shell] = 1;
      const FaceId face = oblique_face(data_, kernel_, shells, shell, f);
      if (material_outside(data_, kernel_, face) == 0) continue;
      report(face, "its shell is not nested as those of a solid are",
             position(brep_.loop_half_edge[brep_.outer_loop[face.value()].value()]));
    }
  }

  const SolidData& data_;
  const Brep& brep_;
  Kernel kernel_;
  std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> validate(const Solid& solid, bool geometry) {
  if (solid.is_empty()) return {};
  return Validator(*solid.data()).run(geometry);
}

}  // namespace sectile
