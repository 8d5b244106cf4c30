#include "story/story_record.h"

#include <algorithm>
#include <atomic>

namespace sectile::viewer {

template <class Event>
EventsByPlace EventsByPlace::of(const std::vector<TraceEvent>& events) {
  const auto visit = [&](const auto& use) {
    for (std::uint32_t i = 0; i < events.size(); ++i)
      if (std::holds_alternative<Event>(events[i]))
        for (const TracePlace& place : places_of(events[i]))
          if (place.number != TracePlace::no_number) use(place.number, i);
  };
  std::size_t places = 0;
  visit([&](std::uint32_t place, std::uint32_t) {
    places = std::max<std::size_t>(places, place + 1);
  });
  EventsByPlace by_place;
  by_place.start_.assign(places + 1, 0);
  visit([&](std::uint32_t place, std::uint32_t) { ++by_place.start_[place + 1]; });
  for (std::size_t p = 0; p < places; ++p) by_place.start_[p + 1] += by_place.start_[p];
  by_place.events_.resize(by_place.start_.back());
  std::vector<std::uint32_t> next(by_place.start_.begin(), by_place.start_.end() - 1);
  visit([&](std::uint32_t place, std::uint32_t i) { by_place.events_[next[place]++] = i; });
  return by_place;
}

std::span<const std::uint32_t> EventsByPlace::at(std::uint32_t place) const {
  if (start_.empty() || place >= start_.size() - 1) return {};
  return std::span(events_).subspan(start_[place], start_[place + 1] - start_[place]);
}

const NeighborhoodEvent* StoryRecord::neighborhood(const std::array<TracePlace, 2>& ends) const {
  for (const std::uint32_t i : neighborhoods.at(ends[0].number)) {
    const auto& event = std::get<NeighborhoodEvent>(events[i]);
    if (event.ends[0].number == ends[0].number && event.ends[1].number == ends[1].number)
      return &event;
  }
  return nullptr;
}

Sight StoryRecord::sight(std::uint32_t place) const {
  Sight best = Sight::edge_through_face;
  for (const std::uint32_t i : contacts.at(place)) {
    const auto& contact = std::get<ContactEvent>(events[i]);
    if (!contact.a.is_face() && !contact.b.is_face()) return Sight::coincident;
    if (contact.a.is_vertex() || contact.b.is_vertex()) best = Sight::vertex_in_face;
  }
  return best;
}

std::uint32_t StoryRecord::main_place(const TraceEvent& event) const {
  const std::span<const TracePlace> places = places_of(event);
  return std::max_element(places.begin(), places.end(),
                          [&](const TracePlace& p, const TracePlace& q) {
                            return sight(p.number) < sight(q.number);
                          })
      ->number;
}

bool has_place(const TraceEvent& event) {
  const std::span<const TracePlace> places = places_of(event);
  return !places.empty() && places.front().number != TracePlace::no_number;
}

bool is_of_one_solid(const WedgeEvent& event) {
  return event.between[0].solid == event.between[1].solid;
}

std::string names_of(const TraceEvent& event, int solid) {
  std::string names;
  for (const TraceEntity& entity : entities_of(event, solid)) {
    if (!names.empty()) names += ' ';
    names += name_of(entity);
  }
  return names;
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

template <class Event>
bool is_edge_and_face(const Event& event) {
  return (event.a.is_edge() && event.b.is_face()) || (event.a.is_face() && event.b.is_edge());
}

// An edge that crosses a face's interior is the plain case, and what follows from it: faces that
// cross, null edges on that edge and in that face, and cuts across faces.
class Specials {
 public:
  explicit Specials(const StoryRecord& record) : record_(record) {}

  bool operator()(const ContactEvent& event) const { return !is_edge_and_face(event); }
  bool operator()(const SegmentEvent& event) const {
    return !event.a.is_face() || !event.b.is_face();
  }
  bool operator()(const NeighborhoodEvent& event) const {
    return event.half_planes.size() != 4 ||
           std::any_of(event.half_planes.begin(), event.half_planes.end(),
                       [](const TraceHalfPlane& h) { return !h.carrier.is_face(); });
  }
  bool operator()(const NullEdgeEvent& event) const {
    if (!event.site || event.site->cuts != 2) return true;
    const auto contacts = record_.contacts.at(event.place.number);
    return std::any_of(contacts.begin(), contacts.end(), [&](std::uint32_t i) {
      return !is_edge_and_face(std::get<ContactEvent>(record_.events[i]));
    });
  }
  bool operator()(const CutEvent& event) const { return !event.carrier.is_face(); }
  bool operator()(const WedgeEvent& event) const { return is_of_one_solid(event); }
  bool operator()(const PartEvent&) const { return false; }
  bool operator()(const ResultEvent&) const { return false; }

 private:
  const StoryRecord& record_;
};

class Recorder : public Observer {
 public:
  explicit Recorder(StoryRecord& record) : record_(record) {}

  void phase_done(Phase phase, const std::vector<TraceEvent>& events) override {
    record_.events.reserve(record_.events.size() + events.size());
    for (const TraceEvent& event : events) {
      // Pieces that nothing was cut between stay as they are.
      const auto* wedge = std::get_if<WedgeEvent>(&event);
      if (wedge != nullptr && !wedge->glued) continue;
      record_.steps.push_back({phase, static_cast<std::uint32_t>(record_.events.size()), false});
      record_.events.push_back(event);
    }
  }

 private:
  StoryRecord& record_;
};

// With an empty operand nothing is to be done and no phase reports.
void add_result_alone(StoryRecord& record) {
  Recorder(record).phase_done(Phase::cleanup, {ResultEvent{record.result.counts()}});
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
                                                const std::atomic<bool>* cancel,
                                                std::optional<SplitBy> split) {
  const auto record = std::make_shared<StoryRecord>();
  record->a = a;
  record->b = b;
  record->operation = operation;
  record->split = split;
  Recorder recorder(*record);
  BooleanOptions options;
  options.observer = &recorder;
  options.cancel = cancel;
  record->result = boolean(a, b, operation, options);
  if (record->steps.empty()) add_result_alone(*record);
  record->contacts = EventsByPlace::of<ContactEvent>(record->events);
  record->neighborhoods = EventsByPlace::of<NeighborhoodEvent>(record->events);
  record->null_edges = EventsByPlace::of<NullEdgeEvent>(record->events);
  const Specials specials(*record);
  for (StepRecord& step : record->steps)
    step.special = std::visit(specials, record->events[step.event]);
  find_phases(*record);
  add_bounds(record->bounds, a);
  if (!split) add_bounds(record->bounds, b);
  return record;
}

}  // namespace sectile::viewer
