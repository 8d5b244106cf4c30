// The document: solids, groups and operations as a tree. A value; copies share the solids, so that
// undo keeps whole scenes.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "scene/pattern.h"
#include "sectile/sectile.h"

namespace sectile::viewer {

/// Names a node for ever, across undo and files. 0 is none.
using NodeId = std::uint32_t;

struct PrimitiveKind;                   // scene/primitive_kind.h
extern const PrimitiveKind block_kind;  // which a primitive is if nothing else is said

/// Parameters of a primitive; which of them count depends on its kind.
struct Primitive {
  const PrimitiveKind* kind = &block_kind;
  Vec3 size{2, 2, 2};  ///< edge lengths
  double radius = 1, top_radius = 0, minor_radius = 0.35, height = 2;
  std::uint32_t segments = 32, rings = 16;
  Profile profile;
  friend bool operator==(const Primitive&, const Primitive&);
};

/// A mesh that came from a file; kept inside the scene so that it does not depend on the file.
struct Imported {
  std::filesystem::path path;
  std::shared_ptr<const PolygonMesh> mesh;
  friend bool operator==(const Imported&, const Imported&);  ///< meshes by value
};

/// A Boolean of the child nodes, in their order.
struct BooleanNode {
  Operation operation = Operation::unite;
  friend bool operator==(const BooleanNode&, const BooleanNode&) = default;
};

/// The part of the only child above or below a plane, which is given in the node's own coordinates
/// (the world's for a node that was not moved), so that the cut moves with the node.
struct SplitNode {
  HalfSpace plane;
  bool above = true;
  friend bool operator==(const SplitNode&, const SplitNode&);
};

/// Holds solids together. Where an operation needs a solid, it is the union of the members.
struct Group {
  friend bool operator==(const Group&, const Group&) = default;
};

/// Placement: scaled, then turned (degrees about x, then y, then z), then moved. Right angles and
/// what doubles hold exactly stay exact.
struct Placement {
  Vec3 position{0, 0, 0}, rotation{0, 0, 0}, scale{1, 1, 1};
  /// The solid stands at position + remainder. What is typed has none; moves and contacts whose
  /// place no double can say leave what is missing here.
  Vec3 remainder{0, 0, 0};
  ExactTransform exact() const;  ///< where the solid really stands
  Transform transform() const;   ///< the same, rounded
  /// Exact as far as two doubles for each coordinate can hold it.
  void move(const Vec3& by);
  /// The placement that comes nearest to a map: exact if there is one without shear.
  static Placement of(const Transform& transform);
  static Placement of(const ExactTransform& transform);
  friend bool operator==(const Placement&, const Placement&) = default;
};

/// Red, green and blue from 0 to 1, as style sheets have them.
using NodeColour = std::array<float, 3>;

struct Node {
  NodeId id = 0;
  std::string name;
  Placement placement;
  bool visible = true;
  std::optional<NodeColour> colour;  ///< none: what its role says
  std::variant<Primitive, Imported, BooleanNode, SplitNode, Group, Pattern> what;
  std::vector<NodeId> children;
  NodeId parent = 0;
  friend bool operator==(const Node&, const Node&) = default;
};

/// What a node is called that was not named: "Block", "Union", …
std::string default_name(const Node& node);

/// Members throw std::out_of_range for an id that does not exist, and std::invalid_argument for
/// what would be no tree (say, a node moved into itself).
class Scene {
 public:
  const std::vector<NodeId>& roots() const { return roots_; }
  const Node* find(NodeId id) const;  ///< null if there is none
  const Node& at(NodeId id) const;
  std::size_t size() const { return nodes_.size(); }
  bool is_empty() const { return nodes_.empty(); }
  /// All nodes, parents before children, in the order of the tree.
  std::vector<NodeId> in_order() const;
  /// The node and all below it, parents before children.
  std::vector<NodeId> subtree(NodeId id) const;
  bool is_below(NodeId id, NodeId ancestor) const;  ///< also true for the ancestor itself
  /// The nodes without those that lie below another one of them.
  std::vector<NodeId> topmost(const std::vector<NodeId>& ids) const;
  /// From the coordinates of a node to the world's, and from those that its placement stands in.
  Transform world(NodeId id) const;
  Transform world_of_parent(NodeId id) const;
  ExactTransform exact_world(NodeId id) const;  ///< the same without rounding
  ExactTransform exact_world_of_parent(NodeId id) const;
  bool is_shown(NodeId id) const;  ///< it and all above it are visible

  NodeId add(Node node, NodeId parent = 0, std::size_t at = SIZE_MAX);  ///< gives id and free name
  /// Copy on write. Not for `id`, `parent` and `children`; valid until the scene is copied.
  Node& edit(NodeId id);
  void rename(NodeId id, const std::string& name);  ///< a free name like it, if it is taken
  void remove(NodeId id);                           ///< with everything below it
  NodeId duplicate(NodeId id);                      ///< with everything below it, beside it
  /// To another place of the tree; it stays where it is in the world, up to rounding. `at` counts
  /// the children as they are before.
  void move(NodeId id, NodeId parent, std::size_t at = SIZE_MAX);
  NodeId combine(const std::vector<NodeId>& operands, Operation operation);  ///< new parent of them
  NodeId group(const std::vector<NodeId>& members);
  void ungroup(NodeId id);  ///< members stay where they are in the world, up to rounding
  /// Above and below a plane given in world coordinates. The part below gets a duplicate.
  std::pair<NodeId, NodeId> split(NodeId id, const HalfSpace& plane);

  /// A scene of given nodes, ids and links included, as files hold them. Throws
  /// std::invalid_argument if they make no tree.
  static Scene from_nodes(std::vector<Node> nodes, std::vector<NodeId> roots);
  friend bool operator==(const Scene&, const Scene&);

 private:
  Node& writable(NodeId id);
  std::vector<NodeId>& siblings(NodeId parent);
  std::size_t place_of(const Node& node) const;
  std::string free_name(const std::string& wanted) const;
  NodeId copy_below(NodeId id, NodeId parent, std::size_t at);
  NodeId gather(Node node, const std::vector<NodeId>& members);

  std::vector<std::shared_ptr<const Node>> nodes_;  // ascending ids
  std::vector<NodeId> roots_;
  NodeId next_ = 1;
};

}  // namespace sectile::viewer
