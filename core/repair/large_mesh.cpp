#include "repair/large_mesh.h"

#include <utility>

#include "storage/faces_as_read.h"

namespace sectile {
namespace {

class Resolver {
 public:
  Resolver(TriangleShells&& read, Rule rule, std::uint32_t origin,
           const arrangement::Steering& steering)
      : read_(std::move(read)),
        shells_(read_.shells),
        rule_(rule),
        origin_(origin),
        steering_(steering) {
    made_.input_vertex = std::move(read_.input_vertex);
  }

  LargeMesh run() {
    if (!find_flat_parts()) return {};
    steering_.step(0.1);
    std::vector<std::uint32_t> shell_of;
    for (std::uint32_t s = 0; s < shells_.size(); ++s) {
      const auto& source = shells_[s].source;
      shell_of.insert(shell_of.end(), source.size(), s);
      made_.source.insert(made_.source.end(), source.begin(), source.end());
    }
    const std::vector<FacePairContact> contacts = find_contacts(shell_of);
    made_.is_tangled =
        any_crosses_itself(contacts, shell_of) || (nothing_may_cross() && !contacts.empty());
    if (made_.is_tangled || nothing_may_cross()) return std::move(made_);
    const std::vector<Solid> all = solids();
    const FacesAsRead as_read = what_was_joined(all);
    made_.united = unite_shells(all, contacts, made_.source, &as_read, origin_, steering_);
    return std::move(made_);
  }

 private:
  // False where the shells are flat in large part, or folded onto themselves.
  bool find_flat_parts() {
    try {
      for (TriangleMesh& shell : shells_) {
        std::optional<FlatPart> part = flat_part_of(shell, origin_);
        if (!part) return false;
        parts_.push_back(*std::move(part));
      }
    } catch (const InvalidSolid&) {
      return false;
    }
    return true;
  }

  // By the rule `odd`, what lies in two shells is empty.
  bool nothing_may_cross() const { return shells_.size() > 1 && rule_ == Rule::odd; }

  std::vector<FacePairContact> find_contacts(std::span<const std::uint32_t> shell_of) {
    SelfTestControl control{steering_.cancel, {}};
    control.is_enough = [&](std::uint32_t f, std::uint32_t g) {
      return nothing_may_cross() || shell_of[f] == shell_of[g];
    };
    if (steering_.progress)
      control.progress = [this](double done) { steering_.progress(0.1 + 0.3 * done); };
    const TriangleSurface surface = surface_of(shells_, parts_);
    const Geometry geometry = geometry_of(shells_.front(), surface);
    return face_contacts(surface, Kernel(geometry), control);
  }

  std::vector<Solid> solids() {
    constexpr std::span<const std::uint32_t> all_alike;
    std::vector<Solid> made;
    for (std::size_t s = 0; s < shells_.size(); ++s)
      made.emplace_back(
          boundary_of(std::move(shells_[s]), std::move(parts_[s]), origin_, all_alike));
    return made;
  }

  // The names only.
  static FacesAsRead what_was_joined(const std::vector<Solid>& solids) {
    FacesAsRead all;
    for (const Solid& s : solids)
      if (const FacesAsRead* read = s.data()->as_read.get())
        all.triangles.insert(all.triangles.end(), read->triangles.begin(), read->triangles.end());
    return all;
  }

  TriangleShells read_;
  std::vector<TriangleMesh>& shells_;
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
