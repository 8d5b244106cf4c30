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
    if (!contacts.empty() && !only_shells_cross(contacts, shells)) return {};
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

  bool only_shells_cross(const std::vector<FacePairContact>& contacts, const Shells& shells) const {
    return rule_ != Rule::odd &&
           std::all_of(contacts.begin(), contacts.end(), [&](const FacePairContact& c) {
             return c.kind == SelfContact::Kind::crossing &&
                    shells.of_face[c.first.value()] != shells.of_face[c.second.value()];
           });
  }

  std::optional<ShellsUnited> united(const std::vector<FacePairContact>& contacts,
                                     const Shells& shells) {
    for (const Sign sign : signs_of_volumes(brep_, geometry_, shells))
      if (sign != Sign::positive) return {};
    steering_.step(0.4);
    const std::vector<Solid> solids = solids_of(shells);
    steering_.step(0.5);
    arrangement::Steering steering{steering_.cancel, {}};
    if (steering_.progress)
      steering.progress = [this](double done) { steering_.progress(0.5 + 0.49 * done); };
    const Solid all = arrangement::combine(solids, Operation::unite, steering);
    const SolidData& made = *all.data();
    const auto slots = made.slots();
    auto data = std::make_shared<SolidData>(std::vector<Slot>(slots.begin(), slots.end()),
                                            made.touches_itself());
    data->origin = origin_;
    ShellsUnited result{data, {}, removed_faces(*data)};
    for (const FacePairContact& c : contacts)
      result.divided.insert(result.divided.end(), {c.first.value(), c.second.value()});
    std::sort(result.divided.begin(), result.divided.end());
    result.divided.erase(std::unique(result.divided.begin(), result.divided.end()),
                         result.divided.end());
    steering_.step(1);
    return result;
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
      faces += slot.block->brep.face_count();
      if (faces < size[shell]) continue;
      solids.emplace_back(std::make_shared<SolidData>(std::move(mine), touches));
      mine.clear();
      faces = 0;
      ++shell;
    }
    return solids;
  }

  std::vector<std::uint32_t> removed_faces(const SolidData& data) const {
    std::vector<std::uint8_t> used;
    for (const Slot& slot : data.slots())
      if (!slot.empty())
        for (const FaceSource& source : slot.block->brep.source) {
          if (source.face >= used.size()) used.resize(source.face + 1, 0);
          used[source.face] = 1;
        }
    std::vector<std::uint32_t> removed;
    for (std::uint32_t f = 0; f < polygons_.source.size(); ++f)
      if (polygons_.source[f] >= used.size() || used[polygons_.source[f]] == 0)
        removed.push_back(f);
    return removed;
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

}  // namespace

std::optional<ShellsUnited> shells_alone(const Polygons& polygons,
                                         const std::vector<std::uint32_t>& mate, Geometry& geometry,
                                         const Kernel& kernel, Rule rule, std::uint32_t origin,
                                         const arrangement::Steering& steering) {
  return ShellUniter(polygons, mate, geometry, kernel, rule, origin, steering).run();
}

}  // namespace sectile
