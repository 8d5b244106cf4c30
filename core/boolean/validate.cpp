#include "sectile/validate.h"

#include <algorithm>

#include "geometry/loop_area.h"
#include "import/contacts.h"
#include "import/nesting.h"
#include "import/shells.h"
#include "sectile/errors.h"
#include "topology/links.h"

namespace sectile {
namespace {

class Validator {
 public:
  Validator(const SolidData& data, const ValidationOptions& options)
      : data_(data), brep_(data.brep()), kernel_(data.geometry()), options_(options) {}

  std::vector<Violation> run() {
    const bool geometry = options_.geometry;
    for (const std::string& what : broken_links(brep_, false)) found_.push_back({what, {}});
    if (!found_.empty()) return std::move(found_);
    check_edges();
    check_loops();
    check_cancelled();
    if (geometry && found_.empty()) check_against_itself();
    check_cancelled();
    if (geometry && found_.empty()) check_nesting();
    return std::move(found_);
  }

 private:
  void check_cancelled() const {
    if (options_.cancel && options_.cancel->load(std::memory_order_relaxed)) throw Cancelled();
  }
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
    for (const FaceId f : brep_.faces())
      for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
        points.clear();
        for_each_in_loop(brep_, l,
                         [&](HalfEdgeId h) { points.push_back(brep_.point_of(brep_.from(h))); });
        const bool outer = l == brep_.outer_loop[f];
        const bool left =
            points.size() > 2 && is_counter_clockwise(kernel_, brep_.plane[f], points);
        if (left != outer)
          report(f, outer ? "its outer loop is clockwise" : "an inner loop is counter-clockwise",
                 position(brep_.loop_half_edge[l]));
      }
  }

  void check_against_itself() {
    for (const FacePairContact& c :
         face_contacts(brep_, kernel_, {options_.cancel, options_.progress})) {
      report(c.first, "and f" + std::to_string(c.second.value()) + " " + in_words(c.kind), c.where);
    }
  }

  // Around each shell there is no material.
  void check_nesting() {
    for (const ShellSurroundings& s : shell_surroundings(data_, kernel_, find_shells(brep_)))
      if (s.material != 0)
        report(s.face, "its shell is not nested as those of a solid are",
               position(brep_.loop_half_edge[brep_.outer_loop[s.face]]));
  }

  const SolidData& data_;
  const Brep& brep_;
  Kernel kernel_;
  const ValidationOptions& options_;
  std::vector<Violation> found_;
};

}  // namespace

std::vector<Violation> validate(const Solid& solid, bool geometry) {
  ValidationOptions options;
  options.geometry = geometry;
  return validate(solid, options);
}

std::vector<Violation> validate(const Solid& solid, const ValidationOptions& options) {
  std::vector<Violation> found;
  if (!solid.is_empty()) found = Validator(*solid.data(), options).run();
  if (options.progress) options.progress(1);
  return found;
}

}  // namespace sectile
