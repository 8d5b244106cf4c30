// What is computed in the background: solids, surfaces, imported files, the story of the steps.
#include "app/session.h"
#include "app/words.h"
#include "scene/transforms.h"

namespace sectile::viewer {

void Session::update(double seconds, bool wait) {
  if (!selection().empty() || mode_ == Mode::steps) view.presented = 0;
  interface.messages.pass(seconds);
  files_.finish(wait);
  results.repair.update(wait);
  look_at_repair();
  if (results.ask(document) && !scene().find(interface.renaming.node)) interface.renaming = {};
  if (results.take(wait))
    for (const std::string& error : results.new_errors(scene())) interface.messages.error(error);
  frame_once_computed();
  tell_story();
  results.player.update(seconds, wait);
  interface.tour.update(*this);
  document.keep_copy();
}

void Session::frame_once_computed() {
  if (!frame_next_ || scene().size() == 0 || is_busy() || bounds_of_all().is_empty()) return;
  frame_next_ = false;
  look_at_all();
  camera_of_model_ = view.camera;
}

NodeId Session::story_node() const {
  const auto tells = [&](NodeId id) {
    const Node* node = scene().find(id);
    return node && (std::holds_alternative<BooleanNode>(node->what) ||
                    std::holds_alternative<SplitNode>(node->what));
  };
  for (NodeId id = selected(); id != 0;) {
    if (tells(id)) return id;
    const Node* node = scene().find(id);
    id = node ? node->parent : 0;
  }
  for (const NodeId id : scene().in_order())
    if (tells(id)) return id;
  return 0;
}

std::size_t Session::told_operand() const {
  const Node* node = scene().find(story_node());
  if (!node || node->children.size() < 2) return 0;
  const std::size_t last = node->children.size() - 1;
  return wished_operand_ == 0 ? last : std::min(wished_operand_, last);
}

void Session::tell_operand(std::size_t which) {
  wished_operand_ = which;
}

void Session::tell_story() {
  const Node* node = mode_ == Mode::steps ? scene().find(story_node()) : nullptr;
  if (!node) return results.player.forget();
  // While the operands are being computed the last story stays.
  if (!results.is_current()) return;
  std::vector<Solid> operands = results.operands_of(scene(), *node);
  if (operands.empty()) return results.player.forget();
  if (const auto* split = std::get_if<SplitNode>(&node->what))
    return results.player.tell(
        operands.front(),
        {pulled_back(split->plane, inverse(scene().world(node->id))), split->above});
  operands.resize(told_operand() + 1);
  results.player.tell(operands, std::get<BooleanNode>(node->what).operation);
}

std::string Session::why_no_story() const {
  const Node* node = scene().find(story_node());
  if (!node)
    return "There is no operation in the scene any more. Press Tab to go back to the model.";
  if (std::holds_alternative<SplitNode>(node->what)) return "The solid is being computed\u2026";
  if (node->children.size() < 2) return "This operation needs a second operand.";
  for (const NodeId child : node->children)
    if (const std::string error = results.error_of(child); !error.empty())
      return "An operand could not be computed: " + error;
  return "The operands are being computed\u2026";
}

bool Session::is_busy() const {
  return interface.recording.has_value() || results.is_computing() || !results.knows(document) ||
         files_.is_busy() || results.repair.is_busy() ||
         (mode_ == Mode::steps && results.player.is_busy());
}

std::string Session::activity() const {
  if (interface.recording)
    return "Recording " + std::to_string(interface.recording->done()) + " of " +
           std::to_string(interface.recording->frames()) + "\u2026";
  if (files_.is_busy()) return files_.activity();
  if (results.repair.is_busy()) return results.repair.activity();
  if (results.is_computing()) return "Computing the result\u2026";
  if (mode_ == Mode::steps && results.player.is_busy()) return "Telling the steps\u2026";
  return {};
}

double Session::progress() const {
  if (interface.recording)
    return static_cast<double>(interface.recording->done()) /
           static_cast<double>(interface.recording->frames());
  if (results.repair.is_busy()) return results.repair.progress();
  return results.progress();
}

void Session::cancel() {
  if (interface.recording) {
    interface.recording->stop(results, view);
    interface.recording.reset();
    interface.messages.tell("Cancelled. Nothing was recorded.");
    return;
  }
  if (results.repair.is_busy()) return results.repair.cancel();
  const bool reading = files_.is_busy();
  files_.give_up_reading();
  results.cancel();
  interface.messages.tell(reading ? "Cancelled. Nothing was opened."
                                  : "Cancelled. The next change computes the result again.");
}

}  // namespace sectile::viewer
