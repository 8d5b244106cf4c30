#include "repair/shells_alone.h"

#include <algorithm>

#include "arrangement/boolean_tree.h"
#include "import/brep_builder.h"
#include "import/contacts.h"
#include "import/flat_edges.h"
#include "import/shells.h"
#include "repair/shells_apart.h"
#include "storage/cut_into_blocks.h"
#include "storage/splice.h"

namespace sectile {
namespace {

class ShellUniter {
 public:
  ShellUniter(const Polygons& polygons, const std::vector<std::uint32_t>& mate, Geometry& geometry,
              const Kernel& kernel, Rule rule, std::uint32_t origin,
              const arrangement::Steering& steering)
      : polygons_(polygons),
        mate_(mate),
        geometry_(geometry),
        kernel_(kernel),
        rule_(rule),
        origin_(origin),
        steering_(steering) {}

  std::optional<ShellsUnited> run() {
    if (mate_.empty()) return {};
    build_brep(polygons_, mate_, brep_);
    set_planes_and_sources(polygons_, origin_, brep_);
    const std::vector<FacePairContact> contacts = face_contacts(brep_, kernel_, part(0.16, 0.29));
    const Shells shells = find_shells(brep_);
    if (!contacts.empty() && (rule_ == Rule::odd || !only_shells_cross(contacts, shells.of_face)))
      return {};
    try {
      pin_flat_edges(brep_, geometry_, kernel_);
    } catch (const InvalidSolid&) {  // faces are folded onto each other
      return {};
    }
    if (!contacts.empty()) return united(contacts, shells);
    if (!shells_are_apart(brep_, geometry_, shells)) return {};
    return as_it_is();
  }

 private:
  SelfTestControl part(double begin, double end) const {
    SelfTestControl control{steering_.cancel, {}};
    if (steering_.progress)
      control.progress = [begin, end, this](double done) {
        steering_.progress(begin + done * (end - begin));
      };
    return control;
  }

  // Copies, where it turns out to be something else.
  std::optional<ShellsUnited> as_it_is() const {
    auto all = std::make_shared<SolidData>();
    all->origin = origin_;
    all->brep() = brep_;
    all->geometry() = geometry_;
    try {
      check_orientation(*all, kernel_);
    } catch (const InvalidSolid&) {
      return {};
    }
    steering_.step(0.9);
    all->cut();
    steering_.step(1);
    return ShellsUnited{std::move(all), {}, {}};
  }

  std::optional<ShellsUnited> united(const std::vector<FacePairContact>& contacts,
                                     const Shells& shells) {
    for (const Sign sign : signs_of_volumes(brep_, geometry_, shells))
      if (sign != Sign::positive) return {};
    steering_.step(0.4);
    const std::vector<Solid> solids = solids_of(shells);
    return unite_shells(solids, contacts, polygons_.source, origin_, steering_);
  }

  // They share nothing, but come out of one cut.
  std::vector<Solid> solids_of(const Shells& shells) const {
    const bool touches = vertices_coincide(brep_, geometry_);
    const std::vector<Slot> slots =
        cut_into_blocks({brep_, geometry_, {}, Places{}, shells.of_face}).slots;
    std::vector<Solid> solids;
    std::size_t shell = 0, faces = 0;
    std::vector<std::size_t> size(shells.count, 0);
    for (const std::uint32_t s : shells.of_face) ++size[s];
    std::vector<Slot> mine;
    for (const Slot& slot : slots) {
      mine.push_back(slot);
      faces += slot.block->face_count();
      if (faces < size[shell]) continue;
      solids.emplace_back(std::make_shared<SolidData>(std::move(mine), touches));
      mine.clear();
      faces = 0;
      ++shell;
    }
    return solids;
  }

  const Polygons& polygons_;
  const std::vector<std::uint32_t>& mate_;
  Geometry& geometry_;
  const Kernel& kernel_;
  Rule rule_;
  std::uint32_t origin_;
  const arrangement::Steering& steering_;
  Brep brep_;
};

std::vector<std::uint32_t> unused_faces(const SolidData& data,
                                        std::span<const std::uint32_t> source) {
  std::vector<std::uint8_t> used;
  for (const Slot& slot : data.slots())
    if (!slot.empty())
      for (const FaceSource& from : slot.block->brep().source) {
        if (from.face >= used.size()) used.resize(from.face + 1, 0);
        used[from.face] = 1;
      }
  std::vector<std::uint32_t> unused;
  for (std::uint32_t f = 0; f < source.size(); ++f)
    if (source[f] >= used.size() || used[source[f]] == 0) unused.push_back(f);
  return unused;
}

std::vector<std::uint32_t> faces_of(std::span<const FacePairContact> contacts) {
  std::vector<std::uint32_t> faces;
  for (const FacePairContact& c : contacts)
    faces.insert(faces.end(), {c.first.value(), c.second.value()});
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

}  // namespace

bool only_shells_cross(std::span<const FacePairContact> contacts,
                       std::span<const std::uint32_t> shell_of) {
  return std::all_of(contacts.begin(), contacts.end(), [&](const FacePairContact& c) {
    return c.kind == SelfContact::Kind::crossing &&
           shell_of[c.first.value()] != shell_of[c.second.value()];
  });
}

ShellsUnited unite_shells(const std::vector<Solid>& solids,
                          std::span<const FacePairContact> contacts,
                          std::span<const std::uint32_t> source, std::uint32_t origin,
                          const arrangement::Steering& steering) {
  steering.step(0.5);
  arrangement::Steering inner{steering.cancel, {}};
  if (steering.progress)
    inner.progress = [&](double done) { steering.progress(0.5 + 0.49 * done); };
  const Solid all = arrangement::combine(solids, Operation::unite, inner);
  const SolidData& made = *all.data();
  const auto slots = made.slots();
  auto data = std::make_shared<SolidData>(std::vector<Slot>(slots.begin(), slots.end()),
                                          made.touches_itself());
  data->origin = origin;
  steering.step(1);
  return {data, faces_of(contacts), unused_faces(*data, source)};
}

std::optional<ShellsUnited> shells_alone(const Polygons& polygons,
                                         const std::vector<std::uint32_t>& mate, Geometry& geometry,
                                         const Kernel& kernel, Rule rule, std::uint32_t origin,
                                         const arrangement::Steering& steering) {
  return ShellUniter(polygons, mate, geometry, kernel, rule, origin, steering).run();
}

}  // namespace sectile
