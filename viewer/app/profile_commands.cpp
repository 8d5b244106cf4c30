// The commands that begin a profile.
#include <memory>
#include <optional>

#include "app/command_lists.h"
#include "app/feature_picking.h"
#include "app/picture_tool.h"
#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

/// Asks for the face to draw upon.
class ProfileOnFace : public PictureTool {
 public:
  std::string title() const override { return "Profile on a face"; }
  std::string hint(const ViewState&) const override { return "Click the face to draw upon."; }
  void follow(Session& session, const Pointer& pointer) override {
    hovered_ = picker_.face_at(session, pointer.at);
  }
  void press(Session& session, const Pointer& pointer) override {
    follow(session, pointer);
    if (!hovered_) {
      session.interface.messages.tell("There is no face under the pointer: click one.");
      return;
    }
    const SnapFeatures::Face& face = hovered_->face();
    const Placement placement = placement_on_plane(face.point, face.normal);
    const Transform back = inverse(placement.transform());
    std::vector<Vec2> guides;
    for (const Vec3& end : hovered_->shown()) {
      const Vec3 p = back(end);
      guides.push_back({p.x, p.y});
    }
    session.interface.profile.begin_new(ProfileUse::extruded, placement, std::move(guides));
    finish();
  }
  void add_to(Picture& picture, const ViewState& view) const override {
    if (hovered_) add_spot(picture, *hovered_, theme(view.dark).hover);
  }

 private:
  FeaturePicker picker_;
  std::optional<PickedSpot> hovered_;
};

Command on_plane(const char* name, const char* title, ProfileUse use, const Vec3& normal) {
  return {name,
          title,
          "Draw an outline with holes; its solid is made from it and the outline can be changed "
          "later.",
          "",
          {},
          [=](InterfaceState& i) {
            const bool turns = use == ProfileUse::turned;
            i.profile.begin_new(use, turns ? Placement() : placement_on_plane({}, normal), {});
          }};
}

bool has_profile(const Document& d) {
  const Node* node = d.scene().find(d.selected());
  const auto* primitive = node ? std::get_if<Primitive>(&node->what) : nullptr;
  return primitive && primitive->kind->profile != ProfileUse::none;
}

}  // namespace

std::vector<Command> profile_commands() {
  return {
      on_plane("profile.xy", "Extrude a profile on the ground (xy)", ProfileUse::extruded,
               {0, 0, 1})
          .after_line(),
      on_plane("profile.xz", "Extrude a profile in the front plane (xz)", ProfileUse::extruded,
               {0, -1, 0}),
      on_plane("profile.yz", "Extrude a profile in the side plane (yz)", ProfileUse::extruded,
               {1, 0, 0}),
      {"profile.face",
       "Extrude a profile on a face\u2026",
       "Click a face, then draw an outline upon it.",
       "",
       {{'P', false, true}},
       begins<ProfileOnFace>(),
       [](const Session& s) { return s.mode() == Mode::model && s.scene().size() > 0; }},
      on_plane("profile.turned", "Turn a profile around the z axis", ProfileUse::turned, {0, 0, 1}),
      Command{"profile.edit",
              "Edit the profile\u2026",
              "Changes the outline of the selected extrusion or revolution.",
              "",
              {{Key::f4}},
              [](Session& s) { s.interface.profile.begin_edit(*s.scene().find(s.selected())); },
              has_profile}
          .after_line(),
  };
}

}  // namespace sectile::viewer
