#include "samples/shapes.h"

#include <numeric>

namespace sectile::samples {

namespace {

using Loop = std::vector<std::uint32_t>;

void add_face(PolygonMesh& mesh, const Loop& corners) {
  mesh.face_sizes.push_back(static_cast<std::uint32_t>(corners.size()));
  mesh.indices.insert(mesh.indices.end(), corners.begin(), corners.end());
}

Loop add_loop(PolygonMesh& mesh, const std::vector<Vec3>& corners) {
  Loop loop(corners.size());
  std::iota(loop.begin(), loop.end(), static_cast<std::uint32_t>(mesh.positions.size()));
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  return loop;
}

/// `near` counter-clockwise as seen from outside; far[i] is joined to near[i]. Both end faces are
/// made of the pieces.
PolygonMesh between(const std::vector<Vec3>& near, const std::vector<Vec3>& far,
                    const std::vector<Loop>& pieces) {
  PolygonMesh mesh;
  const Loop a = add_loop(mesh, near), b = add_loop(mesh, far);
  for (const Loop& piece : pieces) {
    Loop on_near, on_far;
    for (const std::uint32_t corner : piece) {
      on_near.push_back(a[corner]);
      on_far.insert(on_far.begin(), b[corner]);
    }
    add_face(mesh, on_near);
    add_face(mesh, on_far);
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const std::size_t j = (i + 1) % a.size();
    add_face(mesh, {a[j], a[i], b[i], b[j]});
  }
  return mesh;
}

std::vector<Loop> one_piece(std::size_t corners) {
  Loop loop(corners);
  std::iota(loop.begin(), loop.end(), 0u);
  return {loop};
}

}  // namespace

PolygonMesh block(const Vec3& low, const Vec3& high) {
  return along_y({{low.x, low.z}, {high.x, low.z}, {high.x, high.z}, {low.x, high.z}}, low.y,
                 high.y);
}

PolygonMesh along_y(const std::vector<Corner>& profile, double from, double to) {
  return along_y(profile, one_piece(profile.size()), from, to);
}

PolygonMesh along_y(const std::vector<Corner>& profile, const std::vector<Loop>& pieces,
                    double from, double to) {
  std::vector<Vec3> front, back;
  for (const Corner& c : profile) {
    front.push_back({c.u, from, c.v});
    back.push_back({c.u, to, c.v});
  }
  return between(front, back, pieces);
}

PolygonMesh along_x(const std::vector<Corner>& profile, double from, double to) {
  std::vector<Vec3> left, right;
  for (const Corner& c : profile) {
    left.push_back({from, c.u, c.v});
    right.push_back({to, c.u, c.v});
  }
  return between(right, left, one_piece(profile.size()));
}

PolygonMesh cone(const Vec3& apex, const std::vector<Vec3>& base) {
  PolygonMesh mesh;
  const Loop loop = add_loop(mesh, base);
  const std::uint32_t tip = add_loop(mesh, {apex})[0];
  add_face(mesh, loop);
  for (std::size_t i = 0; i < loop.size(); ++i)
    add_face(mesh, {loop[(i + 1) % loop.size()], loop[i], tip});
  return mesh;
}

}  // namespace sectile::samples
