#include <array>

#include "app/icons.h"
#include "app/panels/panels.h"
#include "app/words.h"
#include "scene/primitive_kind.h"

namespace sectile::viewer {
namespace {

/// Fields that change a copy of the node; shown at once, one step of undo when the edit is done.
class Fields {
 public:
  Fields(PanelContext& context, NodeId id)
      : context_(context), node_(*context.session.scene().find(id)) {}

  void draw() {
    ImGui::PushFont(context_.fonts.bold);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(node_.name.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    ImGui::SameLine();
    ImGui::TextDisabled("%s", kind_of(node_).c_str());
    draw_colour();
    draw_position();
    triple("Rotation (degrees)", "rotation", node_.placement.rotation, 0.5, Quantity::angle);
    triple("Scale", "scale", node_.placement.scale, 0.005, Quantity::plain);
    ImGui::Spacing();
    std::visit([&](auto& what) { draw_what(what); }, node_.what);
    draw_numbers();
    // Below all fields, so that none moves under the pointer.
    draw_error();
    apply();
  }

 private:
  /// What is typed is the whole place: nothing remains beside it.
  void draw_position() {
    Vec3& rest = node_.placement.remainder;
    const std::array<double*, 3> rests{&rest.x, &rest.y, &rest.z};
    const std::array<bool, 3> changed =
        triple("Position", "position", node_.placement.position, 0.01, Quantity::length, rest);
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (changed[axis]) *rests[axis] = 0;
  }

  void edited(const char* what, Edited edited) {
    if (edited.changing || edited.done) what_ = what;
    changing_ |= edited.changing;
    done_ |= edited.done;
  }

  void choose(const char* what) { edited(what, {true, true}); }

  void draw_error() {
    const std::string error = context_.session.results.error_of(node_.id);
    if (error.empty()) return;
    ImGui::Separator();
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0.84f, 0.24f, 0.12f, 1));
    ImGui::PushTextWrapPos(0);
    ImGui::Text("%s  %s", icons::warning, error.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    context_.widgets.record_item("properties.error");
  }

  /// Which of the three are other values now, or the same ones typed again.
  std::array<bool, 3> triple(const char* text, const std::string& name, Vec3& value, double speed,
                             Quantity quantity, const Vec3& beside = {}) {
    ImGui::PushFont(context_.fonts.small);
    ImGui::TextDisabled("%s", text);
    ImGui::PopFont();
    const float gap = 4;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
    const std::array<Colour, 3> colours{context_.theme.handle_x, context_.theme.handle_y,
                                        context_.theme.handle_z};
    const std::array<double*, 3> values{&value.x, &value.y, &value.z};
    const std::array<double, 3> rests{beside.x, beside.y, beside.z};
    std::array<bool, 3> changed{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (axis > 0) ImGui::SameLine(0, gap);
      const Edited field = number_field(
          context_, "properties." + name + "." + "xyz" [axis], *values[axis], speed, width,
          quantity, {}, rests[axis]);
      edited(text, field);
      changed[axis] = field.changing;
      const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
      ImGui::GetWindowDrawList()->AddRectFilled({low.x, high.y - 2}, high, packed(colours[axis]));
    }
    return changed;
  }

  void row(const char* text) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    ImGui::SameLine(ImGui::GetContentRegionAvail().x * 0.46f);
  }

  void length(const PrimitiveField& field, double& value) {
    row(field.title);
    edited(field.title, number_field(context_, std::string("properties.") + field.name, value, 0.01,
                                     -1, Quantity::length, {field.low, field.high}));
  }

  void whole(const char* text, const std::string& name, std::uint32_t& value, int low, int high) {
    row(text);
    edited(text, count_field(context_, "properties." + name, value, low, high, -1));
  }

  void draw_what(Primitive& p) {
    for (const PrimitiveField& field : p.kind->fields) {
      if (const auto* size = std::get_if<Vec3 Primitive::*>(&field.value))
        triple(field.title, field.name, p.*(*size), 0.01, Quantity::length);
      else if (const auto* of_length = std::get_if<double Primitive::*>(&field.value))
        length(field, p.*(*of_length));
      else
        whole(field.title, field.name, p.*std::get<std::uint32_t Primitive::*>(field.value),
              static_cast<int>(field.low), static_cast<int>(field.high));
    }
    if (p.kind->profile != ProfileUse::none &&
        button(context_, "properties.profile", "Edit the profile\u2026",
               "Draw and change its outline and holes (F4)", true, -1))
      context_.session.interface.profile.begin_edit(node_);
  }

  void draw_what(Imported& imported) {
    if (!imported.path.empty())
      note(context_, "From " + imported.path.filename().string() + ", kept inside the scene.");
  }

  void draw_what(BooleanNode& node) {
    const float width = (ImGui::GetContentRegionAvail().x - 8) / 3;
    for (const Operation operation :
         {Operation::unite, Operation::intersect, Operation::subtract}) {
      if (operation != Operation::unite) ImGui::SameLine(0, 4);
      if (button(context_, "properties." + name_of(operation), icon_of(operation),
                 capitalised(name_of(operation)) + " the solids below", true, width,
                 node.operation == operation)) {
        node.operation = operation;
        choose("Change the operation");
      }
    }
    if (node_.children.size() == 2 && button(context_, "properties.swap", "Swap A and B",
                                             "Exchanges the two operands", true, -1)) {
      const NodeId id = node_.id, second = node_.children[1];
      context_.session.change("Swap A and B", [&](Scene& changed) { changed.move(second, id, 0); });
    }
    if (button(context_, "properties.steps", std::string(icons::list) + "  Show the steps",
               "Watch how this result comes about (Tab)", true, -1))
      context_.session.set_mode(Mode::steps);
  }

  void draw_what(SplitNode& node) {
    const float width = (ImGui::GetContentRegionAvail().x - 4) / 2;
    for (const bool above : {true, false}) {
      if (!above) ImGui::SameLine(0, 4);
      if (button(context_, above ? "properties.above" : "properties.below",
                 above ? "Above" : "Below", "Which part is kept", true, width,
                 node.above == above)) {
        node.above = above;
        choose("Keep the other part");
      }
    }
    ImGui::TextDisabled("Plane a x + b y + c z + d = 0");
    const float quarter = (ImGui::GetContentRegionAvail().x - 12) / 4;
    const std::array<double*, 4> values{&node.plane.a, &node.plane.b, &node.plane.c, &node.plane.d};
    for (std::size_t i = 0; i < 4; ++i) {
      if (i > 0) ImGui::SameLine(0, 4);
      edited("Move the plane", number_field(context_, std::string("properties.plane.") + "abcd"[i],
                                            *values[i], 0.01, quarter, Quantity::plain));
    }
  }

  void draw_what(Group&) {
    const std::size_t members = node_.children.size();
    note(context_, members == 1 ? "One solid in a group of its own."
                                : count(members) + " solids that move as one.");
  }

  void draw_what(Pattern& p) {
    using Kind = Pattern::Kind;
    if (p.kind != Kind::mirror) whole("Copies", "count", p.count, 1, 1000);
    if (p.kind == Kind::linear) triple("Step", "step", p.step, 0.01, Quantity::length);
    if (p.kind == Kind::polar) {
      row("Angle");
      edited("Angle", number_field(context_, "properties.degrees", p.degrees, 1, -1,
                                   Quantity::angle, {-360, 360}));
    }
    if (p.kind == Kind::polar || p.kind == Kind::mirror) {
      triple(p.kind == Kind::polar ? "Point of the axis" : "Point of the plane", "centre", p.centre,
             0.01, Quantity::length);
      triple(p.kind == Kind::polar ? "Direction of the axis" : "At right angles to it", "axis",
             p.axis, 0.01, Quantity::plain);
    }
    if (p.kind == Kind::mirror &&
        checkbox(context_, "properties.keeps", "Keep the original", p.keeps))
      choose("Keep the original");
    if (p.kind == Kind::path) draw_path(p);
  }

  void draw_path(Pattern& p) {
    if (checkbox(context_, "properties.turns", "Turn with the path", p.turns))
      choose("Turn with the path");
    for (std::size_t i = 0; i < p.path.size(); ++i)
      triple("Corner", "corner." + std::to_string(i + 1), p.path[i], 0.01, Quantity::length);
    const float width = (ImGui::GetContentRegionAvail().x - 4) / 2;
    if (button(context_, "properties.corner.add", "Add corner", "At the end of the path", true,
               width)) {
      const Vec3 a = p.path[p.path.size() - 2], b = p.path.back();
      p.path.push_back({2 * b.x - a.x, 2 * b.y - a.y, 2 * b.z - a.z});
      choose("Add corner");
    }
    ImGui::SameLine(0, 4);
    if (button(context_, "properties.corner.remove", "Remove corner", "The last one",
               p.path.size() > 2, width)) {
      p.path.pop_back();
      choose("Remove corner");
    }
  }

  void number_row(const char* text, const std::string& value) {
    ImGui::TextDisabled("%s", text);
    ImGui::SameLine(ImGui::GetContentRegionAvail().x * 0.46f);
    ImGui::TextUnformatted(value.c_str());
  }

  /// At the right end of the title's line.
  void draw_colour() {
    const Colour& own = context_.theme.neutral;
    NodeColour colour = node_.colour.value_or(NodeColour{own.r, own.g, own.b});
    const float size = ImGui::GetFrameHeight();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - (node_.colour ? 2 * size + 8 : size));
    const bool changed = ImGui::ColorEdit3(
        "##colour", colour.data(), ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoTooltip);
    context_.widgets.record_item("properties.colour");
    const bool done = ImGui::IsItemDeactivatedAfterEdit();
    tooltip("Its colour: click to choose one");
    if (changed) node_.colour = colour;
    if (changed || done) edited("Colour", {changed, done});
    if (!node_.colour) return;
    ImGui::SameLine(0, 4);
    if (!icon_button(context_, "properties.colour.none", icons::cross, "The colour of its role"))
      return;
    node_.colour.reset();
    choose("Colour");
  }

  void draw_numbers() {
    const Solid* solid = context_.session.results.solid(node_.id);
    if (!solid) return;
    ImGui::Separator();
    if (solid->is_empty()) {
      ImGui::PushTextWrapPos(0);
      ImGui::TextUnformatted("The result is empty: no volume is left.");
      ImGui::PopTextWrapPos();
      return;
    }
    const SolidNumbers& numbers = context_.session.results.numbers(node_.id, *solid);
    number_row("Volume", number(numbers.volume));
    number_row("Area", number(numbers.area));
    number_row("Vertices", count(numbers.counts.vertices));
    number_row("Edges", count(numbers.counts.edges));
    number_row("Faces", count(numbers.counts.faces));
    number_row("Shells", count(numbers.counts.shells));
    number_row("Holes (genus)", std::to_string(numbers.counts.genus));
  }

  void apply() {
    if (!changing_ && !done_) return;
    Session& session = context_.session;
    Scene scene = session.scene();
    Node& edited = scene.edit(node_.id);
    edited.placement = node_.placement;
    edited.what = node_.what;
    edited.colour = node_.colour;
    if (changing_) session.document.show_draft(what_, std::move(scene));
    if (done_) session.document.commit_draft();
  }

  PanelContext& context_;
  Node node_;
  const char* what_ = "";
  bool changing_ = false, done_ = false;
};

void draw_several(PanelContext& context, const std::vector<NodeId>& chosen) {
  title(context, (std::to_string(chosen.size()) + " selected").c_str());
  for (std::size_t i = 0; i < chosen.size() && i < 8; ++i) {
    const Colour colour = i == 0 ? context.theme.a : context.theme.b;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddCircleFilled({at.x + 6, at.y + ImGui::GetTextLineHeight() / 2},
                                                5, packed(with_alpha(colour, 1)));
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + 18);
    ImGui::TextUnformatted(context.session.scene().find(chosen[i])->name.c_str());
  }
  note(context,
       "Choose Unite (U), Intersect (I) or Subtract (D). Subtract cuts the others out of the "
       "first.");
}

}  // namespace

void draw_properties(PanelContext& context) {
  // As wide with a scroll bar as without one: fields do not move when numbers come and go.
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::SetNextWindowContentSize(
      {context.layout.properties.width - 2 * style.WindowPadding.x - style.ScrollbarSize - 2, 0});
  begin_panel(context, "properties", context.layout.properties);
  const std::vector<NodeId> chosen = context.session.topmost_selected();
  if (chosen.empty()) {
    title(context, "Properties");
    note(context,
         context.session.scene().size() == 0
             ? "What you select shows its place and its size here."
             : "Click a solid in the picture or in the tree above to see its place and size.");
  } else if (chosen.size() == 1) {
    Fields(context, chosen.front()).draw();
  } else {
    draw_several(context, chosen);
  }
  end_panel();
}

}  // namespace sectile::viewer
