// What a story knows: the events of all phases, found by place, and the surfaces for its pictures.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "picture/surface_mesh.h"
#include "sectile/sectile.h"
#include "story/step.h"
#include "story/story.h"

namespace sectile::viewer {

using Mesh = std::shared_ptr<const SurfaceMesh>;

/// The numbers of events by place, in the order of the events.
class EventsByPlace {
 public:
  EventsByPlace() = default;
  /// Of the events of one kind.
  template <class Event>
  static EventsByPlace of(const std::vector<TraceEvent>& events);
  std::span<const std::uint32_t> at(std::uint32_t place) const;

 private:
  std::vector<std::uint32_t> start_, events_;
};

/// What is to be seen at a place, the most telling last: an edge through a face, a vertex in a
/// face, vertices that coincide (once edges are divided).
enum class Sight : std::uint8_t { edge_through_face, vertex_in_face, coincident };

struct StoryRecord {
  Solid a, b, result;
  Operation operation = Operation::unite;
  std::optional<SplitBy> split;  ///< then b stands for the half-space
  std::vector<TraceEvent> events;
  std::vector<StepRecord> steps;
  std::array<std::size_t, 9> first_step{};  ///< per phase, and one past all
  EventsByPlace contacts, neighborhoods, null_edges;
  Bounds bounds;  ///< of the operands

  const TraceEvent& event(std::size_t step) const { return events[steps[step].event]; }
  /// The neighborhood of the segment between two places; null if there is none.
  const NeighborhoodEvent* neighborhood(const std::array<TracePlace, 2>& ends) const;

  Sight sight(std::uint32_t place) const;
  /// The place of an event whose neighborhood says most; the event has one.
  std::uint32_t main_place(const TraceEvent& event) const;

  /// Made when first asked for.
  const Mesh& operand(int solid) const;
  const Mesh& result_mesh() const;
  /// AinB, AoutB, BinA, BoutA.
  const std::array<Mesh, 4>& four_parts() const;
  /// AinB, AoutB, AonB+, AonB-, and the same of B.
  const std::array<Mesh, 8>& eight_parts() const;

 private:
  mutable std::once_flag operands_once_, result_once_, four_once_, eight_once_;
  mutable std::array<Mesh, 2> operands_;
  mutable Mesh result_mesh_;
  mutable std::array<Mesh, 4> four_;
  mutable std::array<Mesh, 8> eight_;
};

/// Is there a contact point where it takes place?
bool has_place(const TraceEvent& event);
bool is_of_one_solid(const WedgeEvent& event);
/// "v12", "e3 e5" or nothing: the entities of a solid that it is about.
std::string names_of(const TraceEvent& event, int solid);

/// Runs the operation and keeps what it reports.
std::shared_ptr<const StoryRecord> record_story(const Solid& a, const Solid& b, Operation operation,
                                                const std::atomic<bool>* cancel,
                                                std::optional<SplitBy> split = std::nullopt);

/// Coordinates, for the eye.
inline glm::dvec3 to_glm(const Vec3& v) {
  return {v.x, v.y, v.z};
}

}  // namespace sectile::viewer
