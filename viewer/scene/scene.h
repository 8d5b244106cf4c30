// The document: solids, groups and operations as a tree. A value; copies share the solids, so that
// undo keeps whole scenes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "sectile/sectile.h"

namespace sectile::viewer {

/// Names a node for ever, across undo and files. 0 is none.
using NodeId = std::uint32_t;

/// Parameters of a primitive; which of them count depends on the shape.
struct Primitive {
  enum class Shape : std::uint8_t {
    block, wedge, prism, pyramid, cylinder, cone, sphere, torus, extrusion, revolution
  };
  Shape shape = Shape::block;
  Vec3 size{2, 2, 2};                  ///< block, wedge: edge lengths; centred at the origin
  double radius = 1, top_radius = 0, minor_radius = 0.35, height = 2;
  std::uint32_t segments = 32, rings = 16;
  Profile profile;                     ///< extrusion, revolution
  friend bool operator==(const Primitive&, const Primitive&);
};

/// A mesh that came from a file; kept inside the scene so that it does not depend on the file.
struct Imported {
  std::filesystem::path path;
  std::shared_ptr<const PolygonMesh> mesh;
};

/// A Boolean of the child nodes, in their order.
struct BooleanNode {
  Operation operation = Operation::unite;
};

/// The part of the only child above or below a plane given in world coordinates.
struct SplitNode {
  HalfSpace plane;
  bool above = true;
};

struct Group {};

/// Placement: scaled, then turned (degrees about x, then y, then z), then moved. Right angles and
/// what doubles hold exactly stay exact.
struct Placement {
  Vec3 position{0, 0, 0}, rotation{0, 0, 0}, scale{1, 1, 1};
  Transform transform() const;
  friend bool operator==(const Placement&, const Placement&);
};

struct Node {
  NodeId id = 0;
  std::string name;
  Placement placement;
  bool visible = true;
  std::variant<Primitive, Imported, BooleanNode, SplitNode, Group> what;
  std::vector<NodeId> children;
  NodeId parent = 0;
};

class Scene {
 public:
  const std::vector<NodeId>& roots() const { return roots_; }
  const Node* find(NodeId id) const;
  std::size_t size() const { return nodes_.size(); }
  /// All nodes, parents before children, in the order of the tree.
  std::vector<NodeId> in_order() const;

  NodeId add(Node node, NodeId parent = 0, std::size_t at = SIZE_MAX);  ///< gives id and free name
  Node& edit(NodeId id);                    ///< copy on write; throws std::out_of_range
  void remove(NodeId id);                   ///< with everything below it
  NodeId duplicate(NodeId id);              ///< with everything below it, beside it
  void move(NodeId id, NodeId parent, std::size_t at);
  NodeId combine(const std::vector<NodeId>& operands, Operation operation);  ///< new parent of them
  NodeId group(const std::vector<NodeId>& members);
  void ungroup(NodeId id);
  std::pair<NodeId, NodeId> split(NodeId id, const HalfSpace& plane);  ///< above and below
  friend bool operator==(const Scene&, const Scene&);

 private:
  std::vector<std::shared_ptr<const Node>> nodes_;  // ascending ids
  std::vector<NodeId> roots_;
  NodeId next_ = 1;
};

}  // namespace sectile::viewer
