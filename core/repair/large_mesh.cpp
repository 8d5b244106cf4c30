#include "repair/large_mesh.h"

#include <utility>

namespace sectile {
namespace {

class Resolver {
 public:
  Resolver(TriangleShells&& read, Rule rule, std::uint32_t origin,
           const arrangement::Steering& steering)
      : shells_(std::move(read.shells)), rule_(rule), origin_(origin), steering_(steering) {
    made_.input_vertex = std::move(read.input_vertex);
  }

  LargeMesh run() {
    if (!find_flat_parts()) return {};
    steering_.step(0.1);
    const std::vector<FacePairContact> contacts = find_contacts();
    std::vector<std::uint32_t> shell_of;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      const std::vector<std::uint32_t>& source = shells_[s].source;
      shell_of.insert(shell_of.end(), source.size(), s);
      made_.source.insert(made_.source.end(), source.begin(), source.end());
    }
    // By the rule `odd`, what lies in two shells is empty.
    made_.is_tangled = (shells_.size() > 1 && rule_ == Rule::odd && !contacts.empty()) ||
                       !only_shells_cross(contacts, shell_of);
    if (made_.is_tangled || (shells_.size() > 1 && rule_ == Rule::odd)) return std::move(made_);
    made_.united = unite_shells(solids(), contacts, made_.source, origin_, steering_);
    return std::move(made_);
  }

 private:
  // False where the shells are flat in large part, or folded onto themselves.
  bool find_flat_parts() {
    try {
      for (const TriangleMesh& shell : shells_) {
        std::optional<FlatPart> part = flat_part_of(shell, origin_);
        if (!part) return false;
        parts_.push_back(*std::move(part));
      }
    } catch (const InvalidSolid&) {
      return false;
    }
    return true;
  }

  std::vector<FacePairContact> find_contacts() const {
    SelfTestControl control{steering_.cancel, {}};
    if (steering_.progress)
      control.progress = [this](double done) { steering_.progress(0.1 + 0.3 * done); };
    const TriangleSurface surface = surface_of(shells_, parts_);
    Geometry& geometry = *shells_.front().geometry;
    add_planes(surface, geometry);
    std::vector<FacePairContact> contacts = face_contacts(surface, Kernel(geometry), control);
    geometry.planes.clear();
    return contacts;
  }

  std::vector<Solid> solids() {
    std::vector<Solid> made;
    for (std::size_t s = 0; s < shells_.size(); ++s)
      made.emplace_back(boundary_of(shells_[s], std::move(parts_[s]), origin_, {}));
    return made;
  }

  std::vector<TriangleMesh> shells_;
  std::vector<FlatPart> parts_;
  Rule rule_;
  std::uint32_t origin_;
  const arrangement::Steering& steering_;
  LargeMesh made_;
};

}  // namespace

LargeMesh resolve_large_mesh(const SoupView& soup, Rule rule, std::uint32_t origin,
                             const arrangement::Steering& steering) {
  ImportOptions options;
  options.cancel = steering.cancel;
  options.progress = steering.progress;
  std::optional<TriangleShells> read = read_triangle_shells(soup, ImportSteps(options));
  if (!read) return {};
  return Resolver(*std::move(read), rule, origin, steering).run();
}

}  // namespace sectile
