#include "app/chamfer_tool.h"

#include "picture/theme.h"

namespace sectile::viewer {

std::string ChamferTool::hint(const ViewState&) const {
  if (!picked_) return "Click the edge that is to be cut off.";
  const std::string width = "Width " + typed_ + (is_typed_ ? "|" : "");
  if (!problem_.empty()) return width + " \u00B7 " + problem_;
  return width + (is_exact_ ? ", exact" : ", near, not exact (doubles cannot say it)") +
         " \u00B7 Type another \u00B7 Enter or click: take \u00B7 Esc: give back";
}

void ChamferTool::follow(Session& session, const Pointer& pointer) {
  if (!picked_) hovered_ = picker_.edge_at(session, pointer.at);
}

void ChamferTool::press(Session& session, const Pointer& pointer) {
  if (picked_) return take(session);
  const std::optional<PickedSpot> spot = picker_.edge_at(session, pointer.at);
  hovered_.reset();
  if (!spot) {
    session.interface.messages.tell(
        "There is no edge under the pointer: click where one lights up.");
    return;
  }
  try {
    edge_ = chamfer_edge(*spot->features, spot->index);
  } catch (const std::invalid_argument& error) {
    return session.interface.messages.tell(error.what());
  }
  picked_ = spot;
  show(session);
}

void ChamferTool::show(Session& session) {
  session.document.drop_draft();
  problem_.clear();
  try {
    const ChamferCut cut = chamfer_cut(edge_, typed_number(typed_, Quantity::length));
    Scene scene = session.scene();
    Node node;
    node.name = "Chamfered off";
    node.what = cut.prism;
    node.placement = cut.placement;
    const NodeId piece = scene.add(std::move(node));
    const std::string name = scene.at(picked_->mover).name;
    made_ = scene.combine({picked_->mover, piece}, Operation::subtract);
    scene.rename(made_, name + ", chamfered");
    is_exact_ = cut.is_exact;
    session.document.show_draft(title(), std::move(scene));
  } catch (const std::invalid_argument& error) {
    problem_ = error.what();
  }
}

void ChamferTool::take(Session& session) {
  if (!session.document.has_draft()) return show(session);  // or it says why there is none
  session.document.commit_draft();
  session.interface.messages.tell(
      std::string("Chamfer: ") +
      (is_exact_ ? "exact." : "near, not exact (doubles cannot say it)."));
  session.select(made_);
  finish();
}

namespace {

bool can_be_typed(char c) {
  return (c >= '0' && c <= '9') || std::string_view(".,/*+-()").find(c) != std::string_view::npos;
}

}  // namespace

bool ChamferTool::key(Session& session, const Event& event) {
  if (event.key == Key::enter && picked_) {
    take(session);
    return true;
  }
  // Digits come as text, too, and are no commands here.
  if (picked_ && !event.control && static_cast<int>(event.key) < 128 &&
      can_be_typed(static_cast<char>(event.key)))
    return true;
  if (event.key != Key::backspace || !picked_) return false;
  if (!typed_.empty()) typed_.pop_back();
  is_typed_ = true;
  show(session);
  return true;
}

void ChamferTool::text(Session& session, const std::string& typed) {
  if (!picked_) return;
  for (const char c : typed) {
    if (!can_be_typed(c)) continue;
    if (!is_typed_) typed_.clear();
    is_typed_ = true;
    typed_ += c;
  }
  show(session);
}

void ChamferTool::give_up(Session& session) {
  session.document.drop_draft();
}

void ChamferTool::scene_changed(Session& session) {
  if (!picked_) return;
  give_up(session);
  hovered_.reset(), picked_.reset();
  problem_.clear();
  session.interface.messages.tell("The scene has changed: pick again.");
}

void ChamferTool::preview_undone(Session&) {
  picked_.reset();
}

void ChamferTool::add_to(Picture& picture, const ViewState& view) const {
  const Theme& colours = theme(view.dark);
  if (hovered_) add_spot(picture, *hovered_, colours.hover);
  if (picked_) add_spot(picture, *picked_, colours.step);
}

}  // namespace sectile::viewer
