#include "app/picture_maker.h"

#include <algorithm>
#include <array>
#include <set>

#include "app/dimensions.h"
#include "picture/section_lines.h"
#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

constexpr std::size_t most_labels = 300;

bool is_operation(const Node& node) {
  return std::holds_alternative<BooleanNode>(node.what);
}

/// The operation whose operands are drawn with it: the selected one, or the one right above.
NodeId worked_on(const Document& document) {
  const Scene& scene = document.scene();
  const Node* node = scene.find(document.selected());
  if (!node) return 0;
  if (is_operation(*node)) return node->id;
  for (node = scene.find(node->parent); node; node = scene.find(node->parent))
    if (is_operation(*node)) return node->id;
  return 0;
}

class ShapeCollector {
 public:
  explicit ShapeCollector(const Session& session)
      : session_(session),
        theme_(theme(session.view.dark)),
        worked_on_(worked_on(session.document)),
        chosen_(session.topmost_selected()) {}

  std::vector<Shape> run() {
    for (const NodeId root : session_.scene().roots()) add(root);
    return std::move(shapes_);
  }

 private:
  enum class Look { opaque, translucent, outline, tint };

  void add(NodeId id) {
    const Node* node = session_.scene().find(id);
    if (!node || !node->visible || !session_.passes_isolation(id)) return;
    if (std::holds_alternative<Group>(node->what)) {
      for (const NodeId child : node->children) add(child);
      return;
    }
    const bool open = worked_on_ != 0 && session_.scene().is_below(worked_on_, id);
    if (is_presented(*node)) return add_operands(*node);
    // Where they coincide, the result's own edges are drawn over those of the operands.
    if (open && session_.view.shown != Shown::result) add_worked_on(id);
    if (!open || session_.view.shown != Shown::operands)
      add_surface(*node, colour_of(*node), Look::opaque);
  }

  bool is_presented(const Node& node) const {
    return node.id == session_.view.presented && session_.selection().empty() && is_operation(node);
  }

  /// The operands of the operation worked on, which may be far inside of what is drawn.
  void add_worked_on(NodeId drawn) {
    const Node& node = session_.scene().at(worked_on_);
    if (worked_on_ != drawn && session_.is_selected(worked_on_))
      add_surface(node, theme_.result, Look::outline);
    add_operands(node);
  }

  void add_operands(const Node& node) {
    const Operation operation = std::get<BooleanNode>(node.what).operation;
    for (std::size_t i = 0; i < node.children.size(); ++i) {
      const Node* child = session_.scene().find(node.children[i]);
      if (!child || !child->visible) continue;
      if (session_.view.shown == Shown::operands || is_presented(node)) {
        add_operand(*child, i == 0 ? theme_.a : theme_.b, Look::translucent);
        continue;
      }
      add_operand(*child, i == 0 ? theme_.a : theme_.b, Look::outline);
      // What the operation takes away, seen where the result is not: of a difference, from A.
      if (operation == Operation::intersect)
        add_operand(*child, with_alpha(i == 0 ? theme_.a : theme_.b, 0.16f), Look::tint);
      if (operation == Operation::subtract && i == 0)
        add_operand(*child, with_alpha(theme_.b, 0.22f), Look::tint);
    }
  }

  void add_operand(const Node& node, const Colour& colour, Look look) {
    if (std::holds_alternative<Group>(node.what)) {
      for (const NodeId child : node.children)
        if (const Node* found = session_.scene().find(child)) add_operand(*found, colour, look);
      return;
    }
    add_surface(node, colour, look);
  }

  Colour colour_of(const Node& node) const {
    if (node.colour && chosen_.size() < 2)
      return {(*node.colour)[0], (*node.colour)[1], (*node.colour)[2], 1};
    if (node.id == worked_on_ || is_operation(node) ||
        std::holds_alternative<SplitNode>(node.what) || std::holds_alternative<Pattern>(node.what))
      return theme_.result;
    if (chosen_.size() >= 2) {
      const auto found = std::find(chosen_.begin(), chosen_.end(), node.id);
      if (found == chosen_.begin()) return theme_.a;
      if (found != chosen_.end()) return theme_.b;
    }
    return theme_.neutral;
  }

  void add_surface(const Node& node, const Colour& colour, Look look) {
    const Evaluation* evaluation = session_.results.evaluation();
    const Evaluation::Entry* entry = evaluation ? evaluation->find(node.id) : nullptr;
    if (!entry || !entry->surface || entry->surface->positions.empty()) return;
    Shape shape;
    shape.node = node.id;
    shape.is_operand = look != Look::opaque;
    Surface& surface = shape.surface;
    surface.mesh = entry->surface;
    // A result follows its operands when it is computed, not before; all else moves at once.
    surface.model = matrix_of(session_.scene().world(node.id));
    surface.translucent = look == Look::translucent || look == Look::tint;
    surface.colour = surface.translucent ? colour : with_alpha(colour, 1);
    surface.faces = look != Look::outline && !session_.view.wireframe;
    surface.all_edges = session_.view.wireframe && look != Look::outline;
    surface.edges = look != Look::tint;
    surface.yields = look == Look::tint;
    surface.silhouette = look == Look::outline && !session_.view.wireframe;
    surface.highlighted = look != Look::tint && session_.is_selected_with_group(node.id);
    if (look == Look::tint && session_.view.wireframe) return;
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
    std::vector<glm::vec3> ends = shape.surface.mesh->hard_edges;
    ends.insert(ends.end(), shape.surface.mesh->smooth_edges.begin(),
                shape.surface.mesh->smooth_edges.end());
    for (const glm::vec3& p : ends) {
      if (picture.labels.size() >= most_labels) return;
      if (!seen.insert({p.x, p.y, p.z}).second) continue;
      const glm::dvec3 place(shape.surface.model * glm::dvec4(p, 1));
      picture.labels.push_back({place, "v" + std::to_string(seen.size() - 1), colours.text});
    }
  }
}

// What is in the picture, in the order of the theme.
void explain_colours(const Session& session, Picture& picture) {
  if (!session.shows_operands()) return;
  const Theme& t = theme(session.view.dark);
  const auto same = [](const Colour& a, const Colour& b) { return glm::vec3(a) == glm::vec3(b); };
  bool a = false, b = false, removed = false, result = false;
  for (const Surface& surface : picture.surfaces) {
    if (surface.yields) {
      removed = true;
    } else {
      a |= same(surface.colour, t.a);
      b |= same(surface.colour, t.b);
      result |= same(surface.colour, t.result);
    }
  }
  const auto form =
      session.view.shown == Shown::both && result ? LegendKey::Form::line : LegendKey::Form::area;
  if (a) picture.legend.push_back({"A (first)", with_alpha(t.a, 1), form});
  if (b) picture.legend.push_back({"B (the others)", with_alpha(t.b, 1), form});
  if (removed)
    picture.legend.push_back(
        {"removed", fainter(with_alpha(t.b, 1), t, 0.6f), LegendKey::Form::area});
  if (result) picture.legend.push_back({"result", t.result, LegendKey::Form::area});
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
  if (session.view.dimensions || session.document.has_draft())
    add_dimensions(picture, session.document, session.view, shapes);
  explain_colours(session, picture);
  return picture;
}

const Picture& PictureMaker::steps(const Session& session) {
  const ViewSettings& settings = session.view;
  const StoryView view{settings.eight_way, settings.exploded, settings.labels, settings.dark,
                       session.interface.lit_row};
  const StoryPlayer& player = session.results.player;
  if (story_ != player.shared() || step_ != player.step() || phase_ != player.phase() ||
      view != view_) {
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
  const bool tells = session.mode() == Mode::steps && session.results.player.story();
  const bool repairs = session.results.repair.is_open();
  Picture picture = repairs ? picture_of(session.results.repair, theme(view.dark))
                    : tells ? steps(session)
                            : model(session);
  if ((tells || repairs) && view.wireframe)
    for (Surface& surface : picture.surfaces) {
      surface.faces = false;
      surface.all_edges = true;
    }
  picture.hidden_lines = view.hidden_lines;
  picture.camera = session.view.camera;
  picture.surroundings = theme(view.dark).surroundings;
  picture.surroundings.show_grid = view.grid;
  picture.surroundings.show_axes = view.axes;
  picture.section.active = view.section;
  if (view.section) picture.section.plane = session.view.section_plane();
  if (view.section) outline_section(picture);
  return picture;
}

void PictureMaker::outline_section(Picture& picture) {
  std::vector<Surface> cut;
  for (const Surface& surface : picture.surfaces)
    if (!surface.translucent && surface.faces && surface.mesh) cut.push_back(surface);
  if (cut != cut_ || picture.section.plane != plane_) {
    const Bounds bounds = picture.bounds();
    // Less than a pixel, more than what floats lose.
    const double aside = bounds.is_empty() ? 0 : 2e-4 * glm::length(bounds.high - bounds.low);
    outlines_.clear();
    for (const Surface& surface : cut) {
      const std::vector<glm::vec3> more =
          section_lines(*surface.mesh, surface.model, picture.section.plane, aside);
      outlines_.insert(outlines_.end(), more.begin(), more.end());
    }
    cut_ = std::move(cut);
    plane_ = picture.section.plane;
  }
  if (!outlines_.empty())
    picture.lines.push_back({outlines_, picture.surroundings.edge, 2.5f, false});
}

Bounds Session::bounds_shown(bool selected_only) const {
  if (results.repair.is_open()) return picture_of(results.repair, theme(view.dark)).bounds();
  if (mode_ == Mode::steps && results.player.story())
    return results.player.picture({view.eight_way, view.exploded, false, view.dark}).bounds();
  const auto is_meant = [&](NodeId id) {
    if (!selected_only) return true;
    for (const Node* node = scene().find(id); node; node = scene().find(node->parent))
      if (is_selected(node->id)) return true;
    return false;
  };
  Picture shown;
  for (Shape& shape : visible_shapes(*this))
    if (is_meant(shape.node)) shown.surfaces.push_back(std::move(shape.surface));
  return shown.bounds();
}

bool Session::shows_operands() const {
  if (view.presented != 0 && selection().empty()) return true;
  return view.shown != Shown::result &&
         (worked_on(document) != 0 || topmost_selected().size() >= 2);
}

}  // namespace sectile::viewer
