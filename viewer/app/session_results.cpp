// What is computed in the background: solids, surfaces, imported files, the story of the steps.
#include "app/session.h"
#include "app/words.h"
#include "scene/transforms.h"

namespace sectile::viewer {

void Session::update(double seconds, bool wait) {
  if (!selection().empty() || mode_ == Mode::steps) presented = 0;
  messages.pass(seconds);
  files_.finish(wait);
  repair.update(wait);
  look_at_repair();
  evaluate();
  if (wait) evaluator_.wait();
  take_evaluation();
  frame_once_computed();
  tell_story();
  player.update(seconds, wait);
  tour.update(*this);
  document.keep_copy();
}

void Session::evaluate() {
  if (document.revision() == seen_revision_) return;
  seen_revision_ = document.revision();
  if (!scene().find(renaming.node)) renaming = {};
  newest_request_ = evaluator_.request(scene());
}

void Session::take_evaluation() {
  const std::shared_ptr<const Evaluation> latest = evaluator_.latest();
  if (!latest || latest == evaluation_) return;
  evaluation_ = latest;
  tell_new_errors();
}

void Session::tell_new_errors() {
  std::map<NodeId, std::string> errors;
  for (const auto& [id, entry] : evaluation_->nodes) {
    const Node* node = scene().find(id);
    if (entry.error.empty() || !node) continue;
    errors[id] = entry.error;
    const auto told = told_errors_.find(id);
    if (told == told_errors_.end() || told->second != entry.error)
      messages.error(node->name + ": " + entry.error);
  }
  told_errors_ = std::move(errors);
}

void Session::frame_once_computed() {
  if (!frame_next_ || scene().size() == 0 || is_busy() || bounds_of_all().is_empty()) return;
  frame_next_ = false;
  look_at_all();
}

const Solid* Session::solid(NodeId id) const {
  if (!evaluation_) return nullptr;
  const auto found = evaluation_->nodes.find(id);
  if (found == evaluation_->nodes.end() || !found->second.error.empty()) return nullptr;
  return found->second.is_computed ? &found->second.solid : nullptr;
}

std::string Session::error_of(NodeId id) const {
  if (!evaluation_) return {};
  const auto found = evaluation_->nodes.find(id);
  return found == evaluation_->nodes.end() ? std::string() : found->second.error;
}

const SolidNumbers& Session::numbers(NodeId id, const Solid& solid) {
  SolidNumbers& known = numbers_[id];
  if (known.of.data() != solid.data())
    known = {solid, solid.volume(), solid.area(), solid.counts()};
  return known;
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

std::vector<Solid> Session::operands_of(const Node& node) const {
  std::vector<Solid> operands;
  for (const NodeId child : node.children) {
    const Node* found = scene().find(child);
    const Solid* operand = solid(child);
    if (!found || !operand) return {};
    operands.push_back(*operand);
  }
  const std::size_t needed = std::holds_alternative<SplitNode>(node.what) ? 1 : 2;
  return operands.size() < needed ? std::vector<Solid>() : operands;
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
  if (!node) return player.forget();
  // While the operands are being computed the last story stays.
  if (evaluator_.is_busy() || !evaluation_ || evaluation_->request != newest_request_) return;
  std::vector<Solid> operands = operands_of(*node);
  if (operands.empty()) return player.forget();
  if (const auto* split = std::get_if<SplitNode>(&node->what))
    return player.tell(operands.front(),
                       {pulled_back(split->plane, inverse(scene().world(node->id))), split->above});
  operands.resize(told_operand() + 1);
  player.tell(operands, std::get<BooleanNode>(node->what).operation);
}

std::string Session::why_no_story() const {
  const Node* node = scene().find(story_node());
  if (!node)
    return "There is no operation in the scene any more. Press Tab to go back to the model.";
  if (std::holds_alternative<SplitNode>(node->what)) return "The solid is being computed\u2026";
  if (node->children.size() < 2) return "This operation needs a second operand.";
  for (const NodeId child : node->children)
    if (const std::string error = error_of(child); !error.empty())
      return "An operand could not be computed: " + error;
  return "The operands are being computed\u2026";
}

bool Session::is_busy() const {
  return recording.has_value() || evaluator_.is_busy() || document.revision() != seen_revision_ ||
         files_.is_busy() || repair.is_busy() || (mode_ == Mode::steps && player.is_busy());
}

std::string Session::activity() const {
  if (recording)
    return "Recording " + std::to_string(recording->done()) + " of " +
           std::to_string(recording->frames()) + "\u2026";
  if (files_.is_busy()) return files_.activity();
  if (repair.is_busy()) return repair.activity();
  if (evaluator_.is_busy()) return "Computing the result\u2026";
  if (mode_ == Mode::steps && player.is_busy()) return "Telling the steps\u2026";
  return {};
}

double Session::progress() const {
  if (recording)
    return static_cast<double>(recording->done()) / static_cast<double>(recording->frames());
  if (repair.is_busy()) return repair.progress();
  return evaluator_.is_busy() ? evaluator_.progress() : 0;
}

void Session::cancel() {
  if (recording) {
    recording->stop(*this);
    recording.reset();
    messages.tell("Cancelled. Nothing was recorded.");
    return;
  }
  if (repair.is_busy()) return repair.cancel();
  const bool reading = files_.is_busy();
  files_.give_up_reading();
  evaluator_.cancel();
  player.cancel();
  messages.tell(reading ? "Cancelled. Nothing was opened."
                        : "Cancelled. The next change computes the result again.");
}

}  // namespace sectile::viewer
