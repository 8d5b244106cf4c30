#include "repair/shells_alone.h"

#include <algorithm>

#include "arrangement/boolean_tree.h"
#include "import/brep_builder.h"
#include "import/contacts.h"
#include "import/flat_edges.h"
#include "import/join_flat_faces.h"
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
    const Shells shells = find_shells(brep_);
    SelfTestControl control = part(0.16, 0.29);
    control.is_enough = [&](std::uint32_t f, std::uint32_t g) {
      return rule_ == Rule::odd || shells.of_face[f] == shells.of_face[g];
    };
    const std::vector<FacePairContact> contacts = face_contacts(brep_, kernel_, control);
    if (!contacts.empty() && (rule_ == Rule::odd || any_crosses_itself(contacts, shells.of_face)))
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
    all = with_flat_faces_joined(std::move(all), kernel_, {});
    all->cut();
    steering_.step(1);
    return ShellsUnited{std::move(all), {}, {}};
  }

  std::optional<ShellsUnited> united(const std::vector<FacePairContact>& contacts,
                                     const Shells& shells) {
    for (const Sign sign : signs_of_volumes(brep_, geometry_, shells))
      if (sign != Sign::positive) return {};
    steering_.step(0.4);
    const JoinedFaces joined = join_flat_faces(brep_, geometry_, kernel_, {});
    const std::vector<Solid> solids =
        joined.as_read ? solids_of(joined.brep, joined.geometry, find_shells(joined.brep))
                       : solids_of(brep_, geometry_, shells);
    return unite_shells(solids, contacts, polygons_.source, joined.as_read.get(), origin_,
                        steering_);
  }

  // They share nothing, but come out of one cut.
  static std::vector<Solid> solids_of(const Brep& brep, const Geometry& geometry,
                                      const Shells& shells) {
    const bool touches = vertices_coincide(brep, geometry);
    const std::vector<Slot> slots =
        cut_into_blocks({brep, geometry, {}, Places{}, shells.of_face}).slots;
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

// Of the faces with these sources: those of which nothing is in a solid, nor of what they were
// joined to.
std::vector<std::uint32_t> unused_faces(const SolidData& data,
                                        std::span<const std::uint32_t> source,
                                        const FacesAsRead* as_read) {
  std::vector<std::uint8_t> used;
  const auto use = [&](std::uint32_t face) {
    if (face >= used.size()) used.resize(face + 1, 0);
    used[face] = 1;
  };
  const auto is_used = [&](std::uint32_t face) { return face < used.size() && used[face] != 0; };
  for (const Slot& slot : data.slots())
    if (!slot.empty()) slot.block->for_each_source([&](const FaceSource& from) { use(from.face); });
  if (as_read)
    for (const FacesAsRead::Triangle& t : as_read->triangles)
      if (is_used(t.joined)) use(t.source);
  std::vector<std::uint32_t> unused;
  for (std::uint32_t f = 0; f < source.size(); ++f)
    if (!is_used(source[f])) unused.push_back(f);
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

bool any_crosses_itself(std::span<const FacePairContact> contacts,
                        std::span<const std::uint32_t> shell_of) {
  return std::any_of(contacts.begin(), contacts.end(), [&](const FacePairContact& c) {
    return shell_of[c.first.value()] == shell_of[c.second.value()];
  });
}

ShellsUnited unite_shells(const std::vector<Solid>& solids,
                          std::span<const FacePairContact> contacts,
                          std::span<const std::uint32_t> source, const FacesAsRead* as_read,
                          std::uint32_t origin, const arrangement::Steering& steering) {
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
  ShellsUnited united{data, faces_of(contacts), unused_faces(*data, source, as_read)};
  for (const FacePairContact& c : contacts) {
    if (c.kind != SelfContact::Kind::overlap) continue;
    if (united.overlaps == 0) united.first_overlap = c.first.value();
    for (const std::uint32_t f : {c.first.value(), c.second.value()})
      if (source[f] < source[united.first_overlap]) united.first_overlap = f;
    ++united.overlaps;
  }
  return united;
}

std::optional<ShellsUnited> shells_alone(const Polygons& polygons,
                                         const std::vector<std::uint32_t>& mate, Geometry& geometry,
                                         const Kernel& kernel, Rule rule, std::uint32_t origin,
                                         const arrangement::Steering& steering) {
  return ShellUniter(polygons, mate, geometry, kernel, rule, origin, steering).run();
}

}  // namespace sectile
