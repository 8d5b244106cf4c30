// What the pictures of all phases are painted with: operands, contacts, classes, marks and names,
// each explained in the legend.
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "picture/theme.h"
#include "story/neighborhood_mesh.h"
#include "story/story.h"
#include "story/story_record.h"

namespace sectile::viewer {

class StoryCanvas {
 public:
  static constexpr std::size_t no_step = std::numeric_limits<std::size_t>::max();
  /// `current`: the step shown; no_step: the whole phase.
  StoryCanvas(const StoryRecord& record, Phase phase, std::size_t current, const StoryView& view);

 protected:
  using Form = LegendKey::Form;
  // So many places show their sectors at once; more would hide each other.
  static constexpr std::size_t most_fans = 48;

  /// With the names of the steps so far, if they are wanted.
  Picture finished();

  std::size_t done() const;
  const TraceEvent* current() const;
  void explain(const std::string& text, const Colour& colour, Form form);
  std::string name_of_solid(int solid) const;
  void paint_operands(bool as_wires);
  static void add_segment(Lines& lines, const TraceEvent& event);
  Lines lines(Colour colour, float width) const;
  Points points(Colour colour, float size) const;
  void add(Lines made, const char* meaning);
  void add(Points made, const char* meaning);
  void highlight(const TraceEvent& event, float width = 5);
  void paint_all_contacts();
  void paint_contacts(std::size_t from, std::size_t to);
  void paint_classes(const ClassMeshes& meshes, float alpha, bool edges);
  void name_place(const glm::dvec3& place, int solid, const std::string& name);
  void paint_labels();

  const StoryRecord& record_;
  Phase phase_;
  std::size_t first_, last_, current_;  // steps of the phase, and the one shown
  const StoryView& view_;
  const Theme& theme_;
  Picture picture_;

 private:
  Colour class_colour(int solid, std::optional<TraceClass> cls) const;
  std::string name_of_class(int solid, TraceClass cls) const;
  static std::string label_of(const TraceEvent& event);
  void add_label(const TraceEvent& event);
};

}  // namespace sectile::viewer
