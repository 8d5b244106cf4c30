// Handles as lines and small surfaces.
#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <memory>
#include <vector>

#include "scene/handles.h"

namespace sectile::viewer {

namespace {

/// The mesh of an earlier frame, if it is equal: a picture in which nothing changed is not drawn
/// again.
std::shared_ptr<const SurfaceMesh> same_as_before(SurfaceMesh mesh) {
  constexpr std::size_t most = 24;
  thread_local std::vector<std::shared_ptr<const SurfaceMesh>> known;
  const auto same = std::find_if(known.begin(), known.end(), [&](const auto& other) {
    return other->positions == mesh.positions && other->normals == mesh.normals;
  });
  if (same != known.end()) return *same;
  if (known.size() == most) known.erase(known.begin());
  return known.emplace_back(std::make_shared<const SurfaceMesh>(std::move(mesh)));
}

Colour colour_of(int axis, bool is_active) {
  // Told apart by brightness, too, for those who do not see red and green.
  static const Colour colours[3]{
      {0.70f, 0.08f, 0.10f, 1}, {0.16f, 0.50f, 0.07f, 1}, {0.05f, 0.22f, 0.80f, 1}};
  return is_active ? Colour{1.0f, 0.70f, 0.0f, 1} : colours[axis];
}

class Drawing {
 public:
  Drawing(const Handles& handles, std::optional<HandlePart> active, const Camera& camera)
      : handles_(handles), active_(active), camera_(camera) {}

  HandlePicture draw() {
    for (int i = 0; i < 3; ++i) {
      if (handles_.mode == HandleMode::rotate) {
        ring(i);
        continue;
      }
      axis(i);
      if (handles_.mode == HandleMode::move) square(i);
    }
    Points centre;
    centre.places.emplace_back(handles_.origin);
    centre.colour = is_active(HandlePart::centre, 0) ? colour_of(0, true) : Colour{1, 1, 1, 1};
    centre.size = 11;
    made_.points.push_back(std::move(centre));
    return std::move(made_);
  }

 private:
  bool is_active(HandlePart first, int axis) const {
    return active_ && static_cast<int>(*active_) == static_cast<int>(first) + axis;
  }

  glm::vec3 at(const glm::dvec3& from_origin) const {
    return glm::vec3(handles_.origin + handles_.size * from_origin);
  }

  Lines lines(HandlePart first, int axis) const {
    Lines made;
    made.colour = colour_of(axis, is_active(first, axis));
    made.width = is_active(first, axis) ? 4.0f : 3.0f;
    made.on_top = true;
    return made;
  }

  void axis(int i) {
    const glm::dvec3 d = handles_.axes[i], u = handles_.axes[(i + 1) % 3],
                     v = handles_.axes[(i + 2) % 3];
    Lines made = lines(HandlePart::axis_x, i);
    made.ends = {at(d * 0.12), at(d)};
    made_.lines.push_back(made);
    handles_.mode == HandleMode::move ? cone(i, d, u, v) : cube(i, d, u, v);
  }

  void add_triangle(SurfaceMesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    const glm::vec3 n = glm::normalize(glm::cross(b - a, c - a));
    for (const glm::vec3& p : {a, b, c}) {
      mesh.positions.push_back(p);
      mesh.normals.push_back(n);
      mesh.bounds.add(p);
    }
    mesh.faces.push_back(0);
  }

  // In units of the handles' size, so that the mesh of an axis is small numbers around nothing.
  void add(SurfaceMesh mesh, int i, HandlePart first) {
    Surface made;
    made.mesh = same_as_before(std::move(mesh));
    made.colour = colour_of(i, is_active(first, i));
    made.edges = false;
    made.is_tool = true;
    made_.surfaces.push_back(std::move(made));
  }

  void cone(int i, const glm::dvec3& d, const glm::dvec3& u, const glm::dvec3& v) {
    constexpr int steps = 16;
    SurfaceMesh mesh;
    const auto rim = [&](int k) {
      const double a = glm::two_pi<double>() * k / steps;
      return at(d * 0.86 + 0.055 * (std::cos(a) * u + std::sin(a) * v));
    };
    for (int k = 0; k < steps; ++k) {
      add_triangle(mesh, rim(k), rim(k + 1), at(d * 1.05));
      add_triangle(mesh, rim(k + 1), rim(k), at(d * 0.86));
    }
    add(std::move(mesh), i, HandlePart::axis_x);
  }

  void cube(int i, const glm::dvec3& d, const glm::dvec3& u, const glm::dvec3& v) {
    SurfaceMesh mesh;
    const glm::dvec3 directions[3]{d, u, v};
    for (int k = 0; k < 3; ++k)
      for (const double sign : {-1.0, 1.0}) {
        const glm::dvec3 n = directions[k] * sign, a = directions[(k + 1) % 3] * sign,
                         b = directions[(k + 2) % 3];
        const auto corner = [&](double s, double t) { return at(d + 0.05 * (n + s * a + t * b)); };
        add_triangle(mesh, corner(-1, -1), corner(1, -1), corner(1, 1));
        add_triangle(mesh, corner(-1, -1), corner(1, 1), corner(-1, 1));
      }
    add(std::move(mesh), i, HandlePart::axis_x);
  }

  void square(int i) {
    const glm::dvec3 u = handles_.axes[(i + 1) % 3], v = handles_.axes[(i + 2) % 3];
    const glm::vec3 corners[4]{at(0.25 * u + 0.25 * v), at(0.45 * u + 0.25 * v),
                               at(0.45 * u + 0.45 * v), at(0.25 * u + 0.45 * v)};
    Lines made = lines(HandlePart::plane_x, i);
    made.width = 2;
    for (int k = 0; k < 4; ++k)
      made.ends.insert(made.ends.end(), {corners[k], corners[(k + 1) % 4]});
    made_.lines.push_back(std::move(made));
  }

  // The half that is turned towards the eye; all of it while it is dragged or pointed at.
  void ring(int i) {
    constexpr int steps = 96;
    const glm::dvec3 u = handles_.axes[(i + 1) % 3], v = handles_.axes[(i + 2) % 3];
    Lines made = lines(HandlePart::ring_x, i);
    const auto place = [&](int k) {
      const double a = glm::two_pi<double>() * k / steps;
      return std::cos(a) * u + std::sin(a) * v;
    };
    for (int k = 0; k < steps; ++k) {
      const bool is_behind = glm::dot(place(k), camera_.forward()) > 0.15;
      if (is_behind && !is_active(HandlePart::ring_x, i)) continue;
      made.ends.insert(made.ends.end(), {at(place(k)), at(place(k + 1))});
    }
    made_.lines.push_back(std::move(made));
  }

  const Handles handles_;
  const std::optional<HandlePart> active_;
  const Camera& camera_;
  HandlePicture made_;
};

/// How deep the nearest corner of a box lies.
double nearest_depth(const Bounds& box, const Camera& camera) {
  double nearest = glm::dot(box.centre() - camera.position(), camera.forward());
  nearest -= glm::dot((box.high - box.low) * 0.5, glm::abs(camera.forward()));
  return nearest;
}

Handles before(const Bounds& scene, const Handles& handles, const Camera& camera) {
  if (scene.is_empty()) return handles;
  const double deepest =
      glm::dot(handles.origin - camera.position(), camera.forward()) + 1.1 * handles.size;
  // Not so near that the picture's near plane cuts them.
  const double wanted = std::max(0.97 * nearest_depth(scene, camera), 0.08 * camera.distance);
  Handles made = handles;
  if (camera.orthographic) {
    made.origin -= camera.forward() * std::max(0.0, deepest - wanted);
  } else if (wanted < deepest) {
    const double nearer = wanted / deepest;
    made.origin = camera.position() + nearer * (handles.origin - camera.position());
    made.size *= nearer;
  }
  return made;
}

}  // namespace

HandlePicture draw(const Handles& handles, std::optional<HandlePart> active, const Camera& camera,
                   const Bounds& scene) {
  return Drawing(before(scene, handles, camera), active, camera).draw();
}

}  // namespace sectile::viewer
