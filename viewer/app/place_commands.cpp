// The commands that bring solids into contact and into line.
#include <algorithm>
#include <bit>
#include <functional>
#include <memory>

#include "app/command_lists.h"
#include "app/place_tools.h"

namespace sectile::viewer {
namespace {

bool in_model(const Session& s) {
  return s.mode() == Mode::model && s.scene().size() > 0;
}
bool has_selection(const Session& s) {
  return in_model(s) && !s.selection().empty();
}
bool has_two(const Session& s) {
  return in_model(s) && s.topmost_selected().size() >= 2;
}
bool has_three(const Session& s) {
  return in_model(s) && s.topmost_selected().size() >= 3;
}

/// Nodes with their boxes; those of which nothing is computed are left out.
struct Boxed {
  NodeId id;
  ExactBox box;
};
std::vector<Boxed> boxes_of(const Session& session, const Selection& nodes) {
  std::vector<Boxed> made;
  for (const NodeId id : nodes)
    if (ExactBox box = exact_box_of(session.scene(), session.results, id); !box.is_empty())
      made.push_back({id, std::move(box)});
  return made;
}

/// One step of undo; says whether all of it came out exactly.
void place(Session& session, const std::string& what,
           const std::vector<std::pair<NodeId, Landing>>& landings) {
  bool exact = true;
  if (!session.change(what, [&](Scene& scene) {
        for (const auto& [id, landing] : landings) {
          scene.edit(id).placement = landing.placement;
          exact = exact && landing.is_exact;
        }
      }))
    return;
  session.interface.messages.tell(
      what + (exact ? ": exact." : ": near, not exact (sums of two doubles cannot say it)."));
}

void put_on_ground(Session& session) {
  std::vector<std::pair<NodeId, Landing>> landings;
  for (const Boxed& boxed : boxes_of(session, session.topmost_selected()))
    landings.emplace_back(boxed.id, aligned(boxed.box, 2, BoxPlace::low, ExactSum::of({0, 0, 0})));
  place(session, "Put on the ground", landings);
}

void align(Session& session, int axis, BoxPlace where, const std::string& what) {
  std::vector<Boxed> boxed = boxes_of(session, session.topmost_selected());
  if (boxed.size() < 2) return;
  const ExactBox& to = boxed.back().box;  // the one selected last stays
  const ExactSum low = to.low(axis).exact(), high = to.high(axis).exact();
  std::vector<std::pair<NodeId, Landing>> landings;
  for (std::size_t n = 0; n + 1 < boxed.size(); ++n)
    landings.emplace_back(
        boxed[n].id, where == BoxPlace::centre
                         ? centred(boxed[n].box, axis, low, high)
                         : aligned(boxed[n].box, axis, where, where == BoxPlace::low ? low : high));
  place(session, what, landings);
}

/// The first and the last along the axis stay; between all of them are gaps of one size.
void distribute(Session& session, int axis, const std::string& what) {
  std::vector<Boxed> boxed = boxes_of(session, session.topmost_selected());
  if (boxed.size() < 3) return;
  const auto low = [&](std::size_t n) { return boxed[n].box.low(axis).exact(); };
  const auto high = [&](std::size_t n) { return boxed[n].box.high(axis).exact(); };
  std::sort(boxed.begin(), boxed.end(), [&](const Boxed& a, const Boxed& b) {
    return a.box.low(axis).value < b.box.low(axis).value;
  });
  const std::size_t last = boxed.size() - 1;
  ExactSum gaps = low(last);  // all of them together
  gaps.add(high(0), -1);
  for (std::size_t n = 1; n < last; ++n) gaps.add(high(n), -1).add(low(n), 1);
  std::vector<std::pair<NodeId, Landing>> landings;
  ExactSum widths = high(0);
  for (std::size_t n = 1; n < last; ++n) {
    const double part = static_cast<double>(n) / static_cast<double>(last);
    ExactSum at = widths;
    Landing landing = aligned(boxed[n].box, axis, BoxPlace::low, at.add(gaps, part));
    // Parts of the room other than halves, quarters and so on are no doubles.
    landing.is_exact = landing.is_exact && std::has_single_bit(last);
    landings.emplace_back(boxed[n].id, landing);
    widths.add(high(n), 1).add(low(n), -1);
  }
  place(session, what, landings);
}

struct Alignment {
  const char* name;
  const char* title;
  int axis;
  BoxPlace where;
};
constexpr Alignment alignments[] = {
    {"place.left", "Left sides (x)", 0, BoxPlace::low},
    {"place.middle_x", "Middles along x", 0, BoxPlace::centre},
    {"place.right", "Right sides (x)", 0, BoxPlace::high},
    {"place.front", "Front sides (y)", 1, BoxPlace::low},
    {"place.middle_y", "Middles along y", 1, BoxPlace::centre},
    {"place.back", "Back sides (y)", 1, BoxPlace::high},
    {"place.bottom", "Undersides (z)", 2, BoxPlace::low},
    {"place.middle_z", "Middles along z", 2, BoxPlace::centre},
    {"place.top", "Tops (z)", 2, BoxPlace::high},
};

}  // namespace

std::vector<Command> place_commands() {
  std::vector<Command> commands = {
      {"place.face_on_face",
       "Face on face",
       "Click two faces: the first one's solid is turned and moved until they touch.",
       "",
       {{'F', false, true}},
       begins<FaceOnFace>(FlushOptions{}),
       in_model},
      {"place.face_centred",
       "Face centred on face",
       "The same, with the middle of the one face on the middle of the other.",
       "",
       {},
       begins<FaceOnFace>(FlushOptions{true, false}),
       in_model},
      {"place.edge_on_edge",
       "Edge on edge",
       "Click two edges: the first one's solid is turned and moved until they lie on each other.",
       "",
       {{'E', false, true}},
       begins<EdgeOnEdge>(),
       in_model},
      {"place.ground",
       "Put on the ground",
       "Moves the selected solids up or down until they stand on z = 0.",
       "",
       {{Key::end}},
       put_on_ground,
       has_selection},
  };
  for (const Alignment& row : alignments) {
    const std::string what = std::string("Align: ") + row.title;
    commands.push_back({row.name,
                        row.title,
                        "Lines up the boxes of the selected solids with the one selected last.",
                        "",
                        {},
                        [=](Session& s) { align(s, row.axis, row.where, what); },
                        has_two});
    commands.back().submenu = "Align";
    commands.back().begins_group = row.where == BoxPlace::low && row.axis > 0;
  }
  for (const int axis : {0, 1, 2}) {
    const std::string along = std::string("along ") + "xyz"[axis];
    const std::string what = "Distribute " + along;
    commands.push_back({std::string("place.distribute_") + "xyz"[axis],
                        "Equal gaps " + along,
                        "Moves the selected solids between the first and the last until the gaps "
                        "between them are equal.",
                        "",
                        {},
                        [=](Session& s) { distribute(s, axis, what); },
                        has_three});
    commands.back().submenu = "Distribute";
  }
  return commands;
}

}  // namespace sectile::viewer
