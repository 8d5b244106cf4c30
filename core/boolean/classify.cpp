// The four- and eight-way boundary classification as results in their own right (paper, section 4).
#include <span>
#include <vector>

#include "boolean/boolean.h"
#include "boolean/components/components.h"
#include "boolean/loading/load.h"
#include "import/measure.h"

namespace sectile {
namespace {

// Collects the faces of one solid with one label.
class PartBuilder {
 public:
  PartBuilder(const Brep& brep, const Geometry& geometry, SurfacePart& part)
      : brep_(brep),
        geometry_(geometry),
        part_(part),
        number_(geometry.positions.size(), no_vertex) {}

  void add(FaceId f) {
    SurfacePart::Face& face = part_.faces.emplace_back();
    face.source = brep_.source[f];
    for (LoopId l = brep_.outer_loop[f]; l.valid(); l = brep_.next_loop[l]) {
      if (!brep_.loop_half_edge[l].valid()) continue;
      auto& loop = face.loops.emplace_back();
      for_each_in_loop(brep_, l, [&](HalfEdgeId h) {
        const PointId p = brep_.point_of(brep_.from(h));
        if (p != brep_.point_of(brep_.to(h))) loop.push_back(vertex(p));
      });
    }
  }

 private:
  static constexpr std::uint32_t no_vertex = 0xFFFFFFFFu;

  std::uint32_t vertex(PointId p) {
    std::uint32_t& n = number_[p.value()];
    if (n == no_vertex) {
      n = static_cast<std::uint32_t>(part_.positions.size());
      part_.positions.push_back(geometry_.position(p));
    }
    return n;
  }

  const Brep& brep_;
  const Geometry& geometry_;
  SurfacePart& part_;
  std::vector<std::uint32_t> number_;
};

SurfacePart part_of(std::span<const SomeFaces> groups) {
  SurfacePart part;
  for (const SomeFaces& group : groups) {
    PartBuilder builder(group.brep, group.geometry, part);
    for (const FaceId f : group.faces) builder.add(f);
  }
  part.area = area_of(groups);
  return part;
}

SurfacePart collect_part(const Workspace& w, const FaceLabels& labels, Operand s,
                         std::uint8_t label) {
  const Patch& patch = w.patch[s];
  std::vector<SomeFaces> groups{{patch.brep, w.geometry, {}}};
  for (const FaceId f : labels.loaded[s].ids())
    if (labels.loaded[s][f] == label) groups[0].faces.push_back(f);
  if (labels.rest[s].empty()) return part_of(groups);
  // The operands are loaded from one block.
  SomeFaces& rest =
      groups.emplace_back(SomeFaces{patch.solid->brep(), patch.solid->geometry(), {}});
  for (const FaceId f : rest.brep.faces())
    if (labels.rest[s].label(0, f) == label) rest.faces.push_back(f);
  return part_of(groups);
}

std::uint8_t label(Class c) {
  return static_cast<std::uint8_t>(1 + static_cast<int>(c));
}

// All of a solid's boundary as one part, for when the other solid is empty.
SurfacePart whole_boundary(const Solid& solid) {
  if (solid.is_empty()) return {};
  const auto faces = solid.data()->brep().faces();
  const SomeFaces all[] = {
      {solid.data()->brep(), solid.data()->geometry(), {faces.begin(), faces.end()}}};
  return part_of(all);
}

}  // namespace

EightWay classify(const Solid& a, const Solid& b) {
  return classify(a, b, BooleanOptions{});
}

EightWay classify(const Solid& a, const Solid& b, const BooleanOptions& options) {
  EightWay result;
  if (a.is_empty() || b.is_empty()) {
    result.a_out_b = whole_boundary(a);
    result.b_out_a = whole_boundary(b);
    return result;
  }
  const BooleanOptions unobserved = without_observer(options);
  Workspace w(unobserved);
  FacePairs pairs;
  load(w, a.data()->in_one_block(), b.data()->in_one_block(), pairs);
  const CutBoundaries boundaries = cut(w, pairs, {});
  const FaceLabels labels =
      find_components(w, boundaries.contacts, boundaries.neighborhoods, boundaries.joined,
                      [](Operand, Class c) { return label(c); });
  const auto part = [&](Operand s, Class c) { return collect_part(w, labels, s, label(c)); };
  result.a_in_b = part(Operand::a, Class::in);
  result.a_out_b = part(Operand::a, Class::out);
  result.a_on_b_plus = part(Operand::a, Class::on_plus);
  result.a_on_b_minus = part(Operand::a, Class::on_minus);
  result.b_in_a = part(Operand::b, Class::in);
  result.b_out_a = part(Operand::b, Class::out);
  result.b_on_a_plus = part(Operand::b, Class::on_plus);
  result.b_on_a_minus = part(Operand::b, Class::on_minus);
  return result;
}

FourWay classify(const Solid& a, const Solid& b, Operation operation) {
  return classify(a, b, operation, BooleanOptions{});
}

FourWay classify(const Solid& a, const Solid& b, Operation operation,
                 const BooleanOptions& options) {
  FourWay result;
  if (a.is_empty() || b.is_empty()) {
    result.a_out_b = whole_boundary(a);
    result.b_out_a = whole_boundary(b);
    return result;
  }
  const BooleanOptions unobserved = without_observer(options);
  Workspace w(unobserved);
  FacePairs pairs;
  load(w, a.data()->in_one_block(), b.data()->in_one_block(), pairs);
  const Operation wanted[] = {operation};
  const CutBoundaries boundaries = cut(w, pairs, {wanted});
  const FaceLabels labels =
      find_components(w, boundaries.contacts, boundaries.neighborhoods, boundaries.joined,
                      [&](Operand s, Class c) { return label(reclassified(operation, s, c)); });
  result.a_in_b = collect_part(w, labels, Operand::a, label(Class::in));
  result.a_out_b = collect_part(w, labels, Operand::a, label(Class::out));
  result.b_in_a = collect_part(w, labels, Operand::b, label(Class::in));
  result.b_out_a = collect_part(w, labels, Operand::b, label(Class::out));
  return result;
}

}  // namespace sectile
