#include "app/repair_bench.h"

#include <utility>

namespace sectile::viewer {

RepairBench::RepairBench()
    : finder_([](const Wish& wish, WorkState& state) -> std::optional<Found> {
        try {
          return Found{wish.subject.part.mesh,
                       std::make_shared<const MeshDefects>(find_defects(
                           *wish.subject.part.mesh, *wish.subject.refusal, &state.cancelled()))};
        } catch (const Cancelled&) {
          return std::nullopt;
        }
      }),
      maker_([this](const Wish& wish, WorkState& state) -> std::optional<Made> {
        progress_ = 0;
        RepairPreview preview;
        try {
          preview = preview_repair(*wish.subject.part.mesh, wish.choice, &state.cancelled(),
                                   [this](double done) { progress_ = done; });
        } catch (const Cancelled&) {
          return std::nullopt;
        } catch (const std::exception& error) {
          preview.choice = wish.choice;
          preview.refusal = error.what();
        }
        return Made{wish.subject.part.mesh,
                    std::make_shared<const RepairPreview>(std::move(preview))};
      }) {}

RepairBench::~RepairBench() = default;

void RepairBench::put(BrokenMesh mesh) {
  meshes_.push_back(std::move(mesh));
  if (meshes_.size() == 1) begin();
}

void RepairBench::come_behind(NodeId one, NodeId other) {
  for (BrokenMesh& mesh : meshes_)
    if (mesh.behind == one) mesh.behind = other;
}

void RepairBench::begin() {
  // A hole is closed unless a person says no: the preview shows with what.
  choice_ = {};
  choice_.close_holes = subject().refusal->reason() == InvalidSolid::Reason::open;
  defects_.reset();
  preview_.reset();
  shows_after = false;
  lit = -1;
  chosen_ = false;
  finder_.request({subject(), choice_});
}

void RepairBench::choose(const RepairChoice& choice) {
  if (!is_open() || (choice == choice_ && chosen_)) return;
  choice_ = choice;
  preview_.reset();
  chosen_ = true;
  maker_.request({subject(), choice_});
}

void RepairBench::close() {
  finder_.cancel();
  maker_.cancel();
  meshes_.pop_front();
  if (is_open()) begin();
}

void RepairBench::update(bool wait) {
  if (!is_open()) return;
  if (wait) finder_.wait();
  if (auto found = finder_.take(); found && found->of == subject().part.mesh) {
    defects_ = std::move(found->defects);
    looks = true;
    choose(choice_);
  }
  if (wait) maker_.wait();
  if (auto made = maker_.take();
      made && made->of == subject().part.mesh && made->preview->choice == choice_)
    preview_ = std::move(made->preview);
}

bool RepairBench::is_busy() const {
  return is_open() && (finder_.is_busy() || maker_.is_busy());
}

std::string RepairBench::activity() const {
  if (!is_busy()) return {};
  return finder_.is_busy() ? "Looking for what is wrong\u2026" : "Trying the repair\u2026";
}

void RepairBench::cancel() {
  finder_.cancel();
  maker_.cancel();
}

}  // namespace sectile::viewer
