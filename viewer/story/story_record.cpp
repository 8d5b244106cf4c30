#include "story/story_record.h"

#include <algorithm>
#include <atomic>

namespace sectile::viewer {

EventsByPlace::EventsByPlace(const std::vector<TraceEvent>& events, std::string_view kind) {
  std::size_t places = 0;
  for (const TraceEvent& event : events)
    for (const std::uint32_t place : event.places)
      places = std::max<std::size_t>(places, place + 1);
  start_.assign(places + 1, 0);
  const auto visit = [&](const auto& use) {
    for (std::uint32_t i = 0; i < events.size(); ++i)
      if (events[i].kind == kind)
        for (const std::uint32_t place : events[i].places) use(place, i);
  };
  visit([&](std::uint32_t place, std::uint32_t) { ++start_[place + 1]; });
  for (std::size_t p = 0; p < places; ++p) start_[p + 1] += start_[p];
  events_.resize(start_.back());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  visit([&](std::uint32_t place, std::uint32_t i) { events_[next[place]++] = i; });
}

std::span<const std::uint32_t> EventsByPlace::at(std::uint32_t place) const {
  if (place + 1 >= start_.size()) return {};
  return std::span(events_).subspan(start_[place], start_[place + 1] - start_[place]);
}

const TraceEvent* StoryRecord::neighborhood(std::uint32_t from, std::uint32_t to) const {
  for (const std::uint32_t i : neighborhoods.at(from))
    if (events[i].places[0] == from && events[i].places[1] == to) return &events[i];
  return nullptr;
}

Sight StoryRecord::sight(std::uint32_t place) const {
  Sight best = Sight::edge_through_face;
  for (const std::uint32_t i : contacts.at(place)) {
    const TraceEvent& contact = events[i];
    const bool face = contact.a[0] == 'f' || contact.b[0] == 'f';
    const bool vertex = contact.a[0] == 'v' || contact.b[0] == 'v';
    if (!face) return Sight::coincident;
    if (vertex) best = Sight::vertex_in_face;
  }
  return best;
}

std::uint32_t StoryRecord::main_place(const TraceEvent& event) const {
  return *std::max_element(event.places.begin(), event.places.end(),
                           [&](std::uint32_t p, std::uint32_t q) { return sight(p) < sight(q); });
}

const Mesh& StoryRecord::operand(int solid) const {
  std::call_once(operands_once_, [&] { operands_ = {surface_mesh(a), surface_mesh(b)}; });
  return operands_[static_cast<std::size_t>(solid)];
}

const Mesh& StoryRecord::result_mesh() const {
  std::call_once(result_once_, [&] { result_mesh_ = surface_mesh(result); });
  return result_mesh_;
}

const std::array<Mesh, 4>& StoryRecord::four_parts() const {
  std::call_once(four_once_, [&] {
    const FourWay parts = classify(a, b, operation);
    four_ = {surface_mesh(parts.a_in_b), surface_mesh(parts.a_out_b), surface_mesh(parts.b_in_a),
             surface_mesh(parts.b_out_a)};
  });
  return four_;
}

const std::array<Mesh, 8>& StoryRecord::eight_parts() const {
  std::call_once(eight_once_, [&] {
    const EightWay parts = classify(a, b);
    eight_ = {surface_mesh(parts.a_in_b),      surface_mesh(parts.a_out_b),
              surface_mesh(parts.a_on_b_plus), surface_mesh(parts.a_on_b_minus),
              surface_mesh(parts.b_in_a),      surface_mesh(parts.b_out_a),
              surface_mesh(parts.b_on_a_plus), surface_mesh(parts.b_on_a_minus)};
  });
  return eight_;
}

namespace {

bool is_edge_and_face(std::string_view kind) {
  return kind == "edge on face" || kind == "face on edge";
}

// An edge that crosses a face's interior is the plain case, and what follows from it: faces that
// cross, null edges on that edge and in that face, and cuts across faces.
class Specials {
 public:
  explicit Specials(const StoryRecord& record) : record_(record) {}

  bool is_special(const TraceEvent& event) const {
    const std::string_view kind = event.fact("kind");
    if (event.kind == "contact") return !is_edge_and_face(kind);
    if (event.kind == "segment") return kind != "face on face";
    if (event.kind == "neighborhood") return !is_plain_crossing(event);
    if (event.kind == "null edge") return !is_plain_null_edge(event);
    if (event.kind == "cut") return (event.a + event.b)[0] != 'f';
    if (event.kind == "wedge") return event.a.empty() || event.b.empty();
    return false;
  }

 private:
  static bool is_plain_crossing(const TraceEvent& event) {
    return event.half_planes.size() == 4 &&
           std::all_of(event.half_planes.begin(), event.half_planes.end(),
                       [](const TraceHalfPlane& h) { return h.carrier[0] == 'f'; });
  }

  bool is_plain_null_edge(const TraceEvent& event) const {
    if (event.places.empty() || event.fact("cuts there") != "2") return false;
    const auto contacts = record_.contacts.at(event.places[0]);
    return std::all_of(contacts.begin(), contacts.end(), [&](std::uint32_t i) {
      return is_edge_and_face(record_.events[i].fact("kind"));
    });
  }

  const StoryRecord& record_;
};

class Recorder : public Observer {
 public:
  explicit Recorder(StoryRecord& record) : record_(record) {}

  void phase_done(Phase phase, const std::vector<TraceEvent>& events) override {
    record_.events.reserve(record_.events.size() + events.size());
    for (const TraceEvent& event : events) {
      // Pieces that nothing was cut between stay as they are.
      if (event.kind == "wedge" && event.fact("glued") != "yes") continue;
      record_.steps.push_back({phase, static_cast<std::uint32_t>(record_.events.size()), false});
      record_.events.push_back(event);
    }
  }

 private:
  StoryRecord& record_;
};

// With an empty operand nothing is to be done and no phase reports.
void add_result_alone(StoryRecord& record) {
  const SolidCounts c = record.result.counts();
  TraceEvent event;
  event.kind = "result";
  event.facts = {{"vertices", std::to_string(c.vertices)}, {"edges", std::to_string(c.edges)},
                 {"faces", std::to_string(c.faces)},       {"loops", std::to_string(c.loops)},
                 {"shells", std::to_string(c.shells)},     {"genus", std::to_string(c.genus)}};
  Recorder(record).phase_done(Phase::cleanup, {event});
}

void add_bounds(Bounds& bounds, const Solid& solid) {
  for (const Vec3& p : solid.to_mesh().positions) bounds.add(to_glm(p));
}

void find_phases(StoryRecord& record) {
  for (std::size_t p = 0; p < record.first_step.size(); ++p)
    record.first_step[p] = static_cast<std::size_t>(
        std::partition_point(
            record.steps.begin(), record.steps.end(),
            [p](const StepRecord& step) { return static_cast<std::size_t>(step.phase) < p; }) -
        record.steps.begin());
}

}  // namespace

std::shared_ptr<const StoryRecord> record_story(const Solid& a, const Solid& b, Operation operation,
                                                const std::atomic<bool>* cancel) {
  const auto record = std::make_shared<StoryRecord>();
  record->a = a;
  record->b = b;
  record->operation = operation;
  Recorder recorder(*record);
  BooleanOptions options;
  options.observer = &recorder;
  options.cancel = cancel;
  record->result = boolean(a, b, operation, options);
  if (record->steps.empty()) add_result_alone(*record);
  record->contacts = EventsByPlace(record->events, "contact");
  record->neighborhoods = EventsByPlace(record->events, "neighborhood");
  record->null_edges = EventsByPlace(record->events, "null edge");
  const Specials specials(*record);
  for (StepRecord& step : record->steps)
    step.special = specials.is_special(record->events[step.event]);
  find_phases(*record);
  add_bounds(record->bounds, a);
  add_bounds(record->bounds, b);
  return record;
}

}  // namespace sectile::viewer
