#include "app/measure_tool.h"

#include <glm/gtc/constants.hpp>

#include "app/words.h"
#include "picture/theme.h"
#include "scene/transforms.h"

namespace sectile::viewer {
namespace {

Measured measured_of(const PickedSpot& spot) {
  Measured made;
  made.point = spot.point;
  if (spot.kind == PickedFeature::Kind::edge) {
    made.kind = Measured::Kind::edge;
    made.from = spot.edge().from, made.to = spot.edge().to;
  } else if (spot.kind == PickedFeature::Kind::face) {
    made.kind = Measured::Kind::face;
    made.point = spot.face().point;
    made.normal = spot.face().normal;
  }
  return made;
}

std::string text_of(const Measurement& measurement) {
  std::string text;
  for (const Measurement::Fact& fact : measurement.facts) {
    if (!text.empty()) text += " \u00B7 ";
    text += fact.name + " " + number(fact.value);
    if (fact.is_angle) text += "\u00B0";
  }
  return text;
}

std::string text_of(const Circle& circle) {
  const Vec3& c = circle.centre;
  return "Radius " + number(circle.radius) + " \u00B7 Diameter " + number(2 * circle.radius) +
         " \u00B7 Centre " + number(c.x) + ", " + number(c.y) + ", " + number(c.z) + " \u00B7 " +
         count(circle.corners) + " corners";
}

const char* name_of(PickedFeature::Kind kind) {
  return kind == PickedFeature::Kind::vertex ? "Vertex"
         : kind == PickedFeature::Kind::edge ? "Edge"
                                             : "Face";
}

/// A closed ring of lines.
std::vector<glm::vec3> ring(const Circle& circle) {
  const glm::dvec3 n = to_glm(circle.normal);
  const glm::dvec3 aside = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(n, aside)), v = glm::cross(n, u);
  std::vector<glm::vec3> ends;
  constexpr int steps = 96;
  for (int i = 0; i < steps; ++i)
    for (const int k : {i, i + 1}) {
      const double a = glm::two_pi<double>() * k / steps;
      ends.emplace_back(to_glm(circle.centre) +
                        circle.radius * (std::cos(a) * u + std::sin(a) * v));
    }
  return ends;
}

}  // namespace

std::string MeasureTool::hint(const ViewState&) const {
  const std::string next = !first_    ? "Click a vertex, an edge or a face."
                           : !second_ ? "Click a second one to measure between the two."
                                      : "Click again to begin anew.";
  return result_.empty() ? next : result_ + "\n" + next;
}

void MeasureTool::follow(Session& session, const Pointer& pointer) {
  hovered_ = picker_.any_at(session, pointer.at);
}

void MeasureTool::press(Session& session, const Pointer& pointer) {
  const std::optional<PickedSpot> spot = picker_.any_at(session, pointer.at);
  if (!spot || second_) first_.reset(), second_.reset();
  if (spot) (first_ ? second_ : first_) = spot;
  measure();
}

// What was measured may have another size now.
void MeasureTool::scene_changed(Session&) {
  hovered_.reset(), first_.reset(), second_.reset();
  measure();
}

void MeasureTool::measure() {
  circle_.reset();
  measurement_ = {};
  result_.clear();
  if (!first_) return;
  if (second_) {
    measurement_ = measured(measured_of(*first_), measured_of(*second_));
    result_ = text_of(measurement_);
    return;
  }
  measurement_ = measured(measured_of(*first_));
  result_ = std::string(name_of(first_->kind));
  if (!measurement_.facts.empty()) result_ += ": " + text_of(measurement_);
  if (first_->kind == PickedFeature::Kind::edge)
    circle_ = circle_through(first_->features->features(), first_->index);
  if (circle_) result_.append("\n").append(text_of(*circle_));
}

void MeasureTool::add_to(Picture& picture, const ViewState& view) const {
  const Theme& colours = theme(view.dark);
  if (hovered_) add_spot(picture, *hovered_, colours.hover);
  if (first_) add_spot(picture, *first_, colours.a);
  if (second_) add_spot(picture, *second_, colours.b);
  if (circle_) {
    picture.lines.push_back({ring(*circle_), colours.step, 2, true});
    picture.points.push_back({{glm::vec3(to_glm(circle_->centre))}, colours.step, 9});
    picture.labels.push_back(
        {to_glm(circle_->centre), "R " + number(circle_->radius), colours.text, true});
  }
  if (measurement_.shown.size() != 2 || measurement_.facts.empty()) return;
  const glm::dvec3 a = to_glm(measurement_.shown[0]), b = to_glm(measurement_.shown[1]);
  picture.lines.push_back({{glm::vec3(a), glm::vec3(b)}, colours.step, 3, true});
  picture.points.push_back({{glm::vec3(a), glm::vec3(b)}, colours.step, 8});
  picture.labels.push_back(
      {0.5 * (a + b), number(measurement_.facts.front().value), colours.text, true});
}

}  // namespace sectile::viewer
