#include "story/sphere_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace sectile::viewer {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
// Directions are rounded; those that are one are never farther apart than this, and nothing but a
// drawing depends on it.
constexpr double same_angle = 1e-6;

// One side of a contact segment in a face, as seen from the place from which it leaves.
struct Touch {
  glm::dvec3 direction;
  bool after;  // what lies counter-clockwise of the direction
  TraceClass cls;
};

struct Piece {
  double start, end;
  std::optional<TraceClass> cls;
  bool ends_at_contact;
};

double angle(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& normal) {
  const double a = std::atan2(glm::dot(glm::cross(from, to), normal), glm::dot(from, to));
  return a < 0 ? a + full_turn : a;
}

glm::dvec3 rotated(const glm::dvec3& v, const glm::dvec3& normal, double by) {
  return v * std::cos(by) + glm::cross(normal, v) * std::sin(by);
}

glm::dvec3 any_direction(const glm::dvec3& normal) {
  const glm::dvec3 other = std::abs(normal.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(normal, other));
}

class SphereBuilder {
 public:
  SphereBuilder(const StoryRecord& record, std::uint32_t place) : record_(record), place_(place) {}

  SpherePicture run() {
    mark_segments();
    for (int s = 0; s < 2; ++s) {
      std::set<std::pair<TraceEntity::Kind, std::uint32_t>> seen;
      for (const std::uint32_t i : record_.contacts.at(place_)) {
        const auto& contact = std::get<ContactEvent>(record_.events[i]);
        const TraceEntity& entity = s == 0 ? contact.a : contact.b;
        if (seen.insert({entity.kind, entity.number}).second) add_cycle(s, contact);
      }
    }
    return std::move(picture_);
  }

 private:
  static std::string name(int solid, char letter, std::uint32_t number) {
    return std::string(solid == 0 ? "A " : "B ") + letter + std::to_string(number);
  }

  glm::dvec3 direction(const NeighborhoodEvent& segment, bool starts_here) const {
    const glm::dvec3 along = to_glm(segment.ends[1].point) - to_glm(segment.ends[0].point);
    const double length = glm::length(along);
    if (length == 0) return glm::dvec3(0);
    return along * ((starts_here ? 1 : -1) / length);
  }

  void mark_segments() {
    for (const std::uint32_t i : record_.neighborhoods.at(place_)) {
      const auto& segment = std::get<NeighborhoodEvent>(record_.events[i]);
      const bool here = segment.ends[0].number == place_;
      const bool cut = std::any_of(segment.half_planes.begin(), segment.half_planes.end(),
                                   [](const TraceHalfPlane& h) { return h.cut; });
      picture_.marks.push_back({-1, direction(segment, here),
                                "place " + std::to_string(segment.ends[here ? 1 : 0].number), cut});
    }
  }

  // A forward half-plane lies to the left of the segment, seen from outside.
  std::vector<Touch> touches(int solid, std::uint32_t face) const {
    std::vector<Touch> found;
    for (const std::uint32_t i : record_.neighborhoods.at(place_)) {
      const auto& segment = std::get<NeighborhoodEvent>(record_.events[i]);
      const bool here = segment.ends[0].number == place_;
      for (const TraceHalfPlane& h : segment.half_planes)
        if (h.solid == solid && h.face == face)
          found.push_back({direction(segment, here), h.forward == here, h.before});
    }
    return found;
  }

  void add_cycle(int solid, const ContactEvent& contact) {
    const std::size_t first = picture_.arcs.size();
    ends_at_contact_.clear();
    for (const TraceSector& sector : contact.sectors)
      if (sector.solid == solid) add_sector(sector);
    spread(first);
  }

  void add_sector(const TraceSector& sector) {
    const glm::dvec3 normal = to_glm(sector.normal);
    std::vector<Touch> touching = touches(sector.solid, sector.face);
    glm::dvec3 from = to_glm(sector.from), to = to_glm(sector.to);
    const bool whole_face = sector.from_edge == TraceSector::no_edge;
    if (whole_face) from = to = touching.empty() ? any_direction(normal) : touching[0].direction;
    double width = angle(from, to, normal);
    if (width < same_angle && (whole_face || sector.from_edge == sector.to_edge)) width = full_turn;
    if (!whole_face)
      picture_.marks.push_back(
          {sector.solid, glm::vec3(from), name(sector.solid, 'e', sector.from_edge), false});
    for (const Piece& piece : divide(from, normal, width, touching)) {
      const glm::dvec3 start = rotated(from, normal, piece.start),
                       end = piece.end == width ? to : rotated(from, normal, piece.end);
      picture_.arcs.push_back({sector.solid, glm::vec3(start), glm::vec3(end), glm::vec3(normal),
                               name(sector.solid, 'f', sector.face), piece.cls});
      ends_at_contact_.push_back(piece.ends_at_contact);
    }
  }

  // The pieces of a sector between the contact segments in it.
  static std::vector<Piece> divide(const glm::dvec3& from, const glm::dvec3& normal, double width,
                                   const std::vector<Touch>& touching) {
    struct Stop {
      double at;
      const Touch* touch;
    };
    std::vector<Stop> stops;
    for (const Touch& touch : touching) {
      double at = angle(from, touch.direction, normal);
      if (at > full_turn - same_angle) at = 0;
      if (at < same_angle) at = touch.after ? 0 : width;
      if (std::abs(at - width) < same_angle) at = touch.after && width == full_turn ? 0 : width;
      if (at <= width) stops.push_back({at, &touch});
    }
    std::sort(stops.begin(), stops.end(), [](const Stop& p, const Stop& q) {
      return p.at != q.at ? p.at < q.at : p.touch->after < q.touch->after;
    });
    std::vector<Piece> pieces{{0, width, {}, false}};
    for (const Stop& stop : stops) {
      Piece& last = pieces.back();
      if (stop.at >= width) {
        if (!stop.touch->after) last.cls = stop.touch->cls;
        last.ends_at_contact = true;
      } else if (stop.at <= same_angle || stop.at - last.start < same_angle) {
        if (stop.touch->after) last.cls = stop.touch->cls;
      } else {
        if (!stop.touch->after) last.cls = stop.touch->cls;
        last.end = stop.at;
        last.ends_at_contact = true;
        pieces.push_back({stop.at, width, {}, false});
        if (stop.touch->after) pieces.back().cls = stop.touch->cls;
      }
    }
    return pieces;
  }

  // Within a cycle the class changes at contact segments only.
  void spread(std::size_t first) {
    const std::size_t count = picture_.arcs.size() - first;
    const auto arc = [&](std::size_t i) -> SpherePicture::Arc& {
      return picture_.arcs[first + i % count];
    };
    for (std::size_t i = 0; i < 2 * count; ++i)
      if (!arc(i + 1).cls && !ends_at_contact_[i % count]) arc(i + 1).cls = arc(i).cls;
    for (std::size_t i = 2 * count; i-- > 0;)
      if (!arc(i).cls && !ends_at_contact_[i % count]) arc(i).cls = arc(i + 1).cls;
  }

  const StoryRecord& record_;
  std::uint32_t place_;
  SpherePicture picture_;
  std::vector<bool> ends_at_contact_;
};

}  // namespace

SpherePicture sphere_at(const StoryRecord& record, std::uint32_t place) {
  return SphereBuilder(record, place).run();
}

}  // namespace sectile::viewer
