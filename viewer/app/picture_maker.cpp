#include "app/picture_maker.h"

#include <algorithm>
#include <array>
#include <set>

#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr std::size_t most_labels = 300;

bool is_operation(const Node& node) {
  return std::holds_alternative<BooleanNode>(node.what);
}

/// The operation whose operands are drawn with it: the selected one, or the one right above.
NodeId worked_on(const Session& session) {
  const Node* node = session.scene().find(session.selected());
  if (!node) return 0;
  if (is_operation(*node)) return node->id;
  for (node = session.scene().find(node->parent); node; node = session.scene().find(node->parent))
    if (is_operation(*node)) return node->id;
  return 0;
}

class ShapeCollector {
 public:
  explicit ShapeCollector(const Session& session)
      : session_(session),
        theme_(theme(session.view.dark)),
        worked_on_(worked_on(session)),
        chosen_(session.topmost_selected()) {}

  std::vector<Shape> run() {
    for (const NodeId root : session_.scene().roots()) add(root);
    return std::move(shapes_);
  }

 private:
  void add(NodeId id) {
    const Node* node = session_.scene().find(id);
    if (!node || !node->visible) return;
    if (std::holds_alternative<Group>(node->what)) {
      for (const NodeId child : node->children) add(child);
      return;
    }
    const bool open = id == worked_on_;
    if (!open || session_.view.shown != Shown::operands)
      add_surface(*node, colour_of(*node), false);
    if (open && session_.view.shown != Shown::result) add_operands(*node);
  }

  void add_operands(const Node& node) {
    for (std::size_t i = 0; i < node.children.size(); ++i)
      if (const Node* child = session_.scene().find(node.children[i]); child && child->visible)
        add_operand(*child, i == 0 ? theme_.a : theme_.b);
  }

  void add_operand(const Node& node, const Colour& colour) {
    if (std::holds_alternative<Group>(node.what)) {
      for (const NodeId child : node.children)
        if (const Node* found = session_.scene().find(child)) add_operand(*found, colour);
      return;
    }
    // Over an opaque result only a breath of the operands remains.
    const bool alone = session_.view.shown == Shown::operands;
    add_surface(node, alone ? colour : with_alpha(colour, 0.22f), true);
  }

  Colour colour_of(const Node& node) const {
    if (node.id == worked_on_ || is_operation(node) || std::holds_alternative<SplitNode>(node.what))
      return theme_.result;
    if (chosen_.size() >= 2) {
      const auto found = std::find(chosen_.begin(), chosen_.end(), node.id);
      if (found == chosen_.begin()) return theme_.a;
      if (found != chosen_.end()) return theme_.b;
    }
    return theme_.neutral;
  }

  void add_surface(const Node& node, const Colour& colour, bool translucent) {
    const Evaluation* evaluation = session_.evaluation();
    const Evaluation::Entry* entry = evaluation ? evaluation->find(node.id) : nullptr;
    if (!entry || !entry->surface || entry->surface->positions.empty()) return;
    Shape shape;
    shape.node = node.id;
    shape.is_operand = translucent;
    Surface& surface = shape.surface;
    surface.mesh = entry->surface;
    // A result follows its operands when it is computed, not before; all else moves at once.
    surface.model = matrix_of(session_.scene().world(node.id));
    const bool pair =
        chosen_.size() >= 2 && colour != theme_.neutral && session_.is_selected(node.id);
    surface.translucent = translucent || pair;
    surface.colour = surface.translucent ? colour : with_alpha(colour, 1);
    surface.faces = !session_.view.wireframe;
    surface.highlighted = session_.is_selected(node.id);
    shapes_.push_back(std::move(shape));
  }

  const Session& session_;
  const Theme& theme_;
  NodeId worked_on_;
  std::vector<NodeId> chosen_;
  std::vector<Shape> shapes_;
};

/// Names the vertices of the selected solids, or of all.
void add_labels(const Session& session, const std::vector<Shape>& shapes, Picture& picture) {
  const Theme& colours = theme(session.view.dark);
  for (const Shape& shape : shapes) {
    if (!session.selection().empty() && !session.is_selected(shape.node)) continue;
    std::set<std::array<float, 3>> seen;
    for (const glm::vec3& p : shape.surface.mesh->hard_edges) {
      if (picture.labels.size() >= most_labels) return;
      if (!seen.insert({p.x, p.y, p.z}).second) continue;
      const glm::dvec3 place(shape.surface.model * glm::dvec4(p, 1));
      picture.labels.push_back({place, "v" + std::to_string(seen.size() - 1), colours.text});
    }
  }
}

bool same(const StoryView& a, const StoryView& b) {
  return a.eight_way == b.eight_way && a.exploded == b.exploded && a.labels == b.labels &&
         a.dark == b.dark;
}

}  // namespace

std::vector<Shape> visible_shapes(const Session& session) {
  return ShapeCollector(session).run();
}

Picture PictureMaker::model(const Session& session) const {
  Picture picture;
  const std::vector<Shape> shapes = visible_shapes(session);
  for (const Shape& shape : shapes) picture.surfaces.push_back(shape.surface);
  if (session.view.labels) add_labels(session, shapes, picture);
  return picture;
}

const Picture& PictureMaker::steps(const Session& session) {
  const ViewSettings& settings = session.view;
  const StoryView view{settings.eight_way, settings.exploded, settings.labels, settings.dark};
  const StoryPlayer& player = session.player;
  if (story_ != player.shared() || step_ != player.step() || phase_ != player.phase() ||
      !same(view, view_)) {
    picture_ = player.picture(view);
    story_ = player.shared();
    step_ = player.step();
    phase_ = player.phase();
    view_ = view;
  }
  return picture_;
}

Picture PictureMaker::make(const Session& session) {
  const ViewSettings& view = session.view;
  const bool tells = session.mode() == Mode::steps && session.player.story();
  Picture picture = tells ? steps(session) : model(session);
  if (tells && view.wireframe)
    for (Surface& surface : picture.surfaces) surface.faces = false;
  picture.camera = session.camera;
  picture.surroundings = theme(view.dark).surroundings;
  picture.surroundings.show_grid = view.grid;
  picture.surroundings.show_axes = view.axes;
  picture.section.active = view.section;
  if (view.section) picture.section.plane = session.section_plane();
  return picture;
}

bool Session::shows_operands() const {
  return view.shown != Shown::result && (worked_on(*this) != 0 || topmost_selected().size() >= 2);
}

}  // namespace sectile::viewer
