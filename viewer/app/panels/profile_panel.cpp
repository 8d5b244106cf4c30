// The dialog in which profiles are drawn and changed.
#include <algorithm>

#include "app/interface_input.h"
#include "app/panels/panels.h"
#include "app/words.h"

namespace sectile::viewer {
namespace {

using Corner = ProfileSketch::Corner;

class ProfilePanel {
 public:
  explicit ProfilePanel(PanelContext& context)
      : context_(context), editor_(context.session.interface.profile), sketch_(editor_.sketch) {}

  void draw() {
    const float side = 210, below = ImGui::GetFrameHeightWithSpacing() + 40;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    draw_profile_canvas(context_, room.x - side - 10, room.y - below);
    ImGui::SameLine(0, 10);
    ImGui::BeginChild("profile numbers", {side, room.y - below});
    draw_numbers();
    ImGui::EndChild();
    const std::string problem = sketch_.problem(editor_.primitive);
    note(context_, problem.empty() ? "All is well. Click to draw another loop, as a hole; drag "
                                     "corners; double click a side for a new corner."
                                   : problem);
    context_.widgets.record_item("profile.note");
    draw_answers(problem.empty());
    if (!ImGui::GetIO().WantTextInput && context_.session.interface.typed.field.empty())
      keys(problem.empty());
  }

 private:
  Edited field(const char* text, const char* name, double& value,
               Quantity quantity = Quantity::length) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(88);
    return number_field(context_, name, value, 0.05, -1, quantity);
  }

  /// All of a drag of a field is one step.
  void move_by_field(const Corner& corner, const Edited& a, const Edited& b, const Vec2& place) {
    if (a.changing || b.changing) {
      sketch_.begin_move();
      sketch_.move(corner, place);
    }
    if (a.done || b.done) sketch_.end_move();
  }

  void draw_numbers() {
    if (editor_.primitive.kind->profile == ProfileUse::extruded) {
      field("Height", "profile.height", editor_.primitive.height);
    } else {
      ImGui::AlignTextToFramePadding();
      ImGui::TextUnformatted("Segments");
      ImGui::SameLine(88);
      count_field(context_, "profile.segments", editor_.primitive.segments, 3, 512, -1);
    }
    ImGui::Separator();
    if (!sketch_.drawn().empty())
      draw_next();
    else if (editor_.selected)
      draw_corner();
    else
      draw_shapes();
  }

  void draw_next() {
    title(context_, "Next side");
    field("Length", "profile.next.length", editor_.next.length);
    field("Angle \u00B0", "profile.next.angle", editor_.next.degrees, Quantity::angle);
    if (button(context_, "profile.next.add", "Add side", "From the last corner",
               editor_.next.length != 0, -1))
      sketch_.add_corner(end_of(sketch_.drawn().back(), editor_.next));
    if (button(context_, "profile.close", "Close the outline", "Enter does it too",
               sketch_.drawn().size() >= 3, -1))
      sketch_.close();
  }

  void draw_corner() {
    const Corner corner = *editor_.selected;
    title(context_, "Corner");
    Vec2 place = sketch_.at(corner);
    const Edited x = field("x", "profile.corner.x", place.x);
    const Edited y = field("y", "profile.corner.y", place.y);
    move_by_field(corner, x, y, place);
    title(context_, "Side before it");
    const Vec2 from = sketch_.before(corner);
    SketchSide side = side_between(from, sketch_.at(corner));
    const Edited length = field("Length", "profile.side.length", side.length);
    const Edited angle = field("Angle \u00B0", "profile.side.angle", side.degrees, Quantity::angle);
    move_by_field(corner, length, angle, end_of(from, side));
    ImGui::Spacing();
    if (button(context_, "profile.corner.remove", "Remove corner", "Del does it too", true, -1))
      remove_selected();
    else if (button(context_, "profile.loop.remove", "Remove loop", "All of this outline", true,
                    -1))
      sketch_.remove_loop(corner.loop), editor_.selected.reset();
  }

  void draw_shapes() {
    title(context_, "Rectangle");
    field("Width", "profile.width", editor_.width);
    field("Height", "profile.rectangle_height", editor_.height);
    if (button(context_, "profile.rectangle", "Add rectangle", "In the middle of the view",
               editor_.width > 0 && editor_.height > 0, -1))
      sketch_.add_loop(rectangle_loop(middle(), editor_.width, editor_.height));
    title(context_, "Circle");
    field("Radius", "profile.radius", editor_.radius);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Corners");
    ImGui::SameLine(88);
    count_field(context_, "profile.corners", editor_.corners, 3, 512, -1);
    if (button(context_, "profile.circle", "Add circle", "In the middle of the view",
               editor_.radius > 0, -1))
      sketch_.add_loop(circle_loop(middle(), editor_.radius, editor_.corners));
  }

  /// The middle of the view, on round numbers.
  Vec2 middle() const {
    return {0.25 * std::round(4 * editor_.centre.x), 0.25 * std::round(4 * editor_.centre.y)};
  }

  void draw_answers(bool is_well) {
    if (button(context_, "profile.undo", "Undo", "Takes back the last change here (Ctrl+Z)",
               sketch_.can_undo(), 90))
      undo();
    ImGui::SameLine(0, 6);
    if (button(context_, "profile.fit", "Show all", "Brings everything into view", true, 90))
      editor_.fit = true;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - 2 * 110 - 6);
    if (button(context_, "profile.cancel", "Cancel", "", true, 110)) editor_.open = false;
    ImGui::SameLine(0, 6);
    if (button(context_, "profile.done", editor_.node ? "Change" : "Make solid", "", is_well, 110))
      context_.session.take_profile();
  }

  void keys(bool is_well) {
    using interface_input::was_pressed;
    const ImGuiIO& io = ImGui::GetIO();
    if (was_pressed(Key::enter)) {
      if (!sketch_.drawn().empty())
        sketch_.close();
      else if (is_well)
        context_.session.take_profile();
    }
    if (was_pressed(Key::del) && editor_.selected) remove_selected();
    if (io.KeyCtrl && was_pressed(static_cast<Key>('Z'))) undo();
    if (was_pressed(Key::escape)) {
      if (editor_.selected)
        editor_.selected.reset();
      else
        editor_.open = false;
    }
  }

  void undo() {
    sketch_.undo();
    editor_.selected.reset();
  }

  void remove_selected() {
    sketch_.remove(*editor_.selected);
    editor_.selected.reset();
  }

  PanelContext& context_;
  ProfileEditor& editor_;
  ProfileSketch& sketch_;
};

}  // namespace

void draw_profile_editor(PanelContext& context) {
  ProfileEditor& editor = context.session.interface.profile;
  if (!editor.open) return;
  constexpr const char* name = "Profile###profile";
  if (!ImGui::IsPopupOpen(name)) ImGui::OpenPopup(name);
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(900.0f, screen.x - 40), std::min(640.0f, screen.y - 60)});
  if (!ImGui::BeginPopupModal(name, &editor.open,
                              ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav))
    return;
  context.widgets.record_window("panel.profile");
  ProfilePanel(context).draw();
  if (!editor.open) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace sectile::viewer
