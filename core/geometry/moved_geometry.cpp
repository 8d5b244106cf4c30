#include "geometry/moved_geometry.h"

#include <algorithm>

#include "geometry/kernel.h"

namespace sectile {
namespace {

// An axis that a direction has, or -1.
int axis_along(const ExactDirection& direction) {
  int axis = -1;
  for (int k = 0; k < 3; ++k) {
    if (direction.d[k].exact().sign() == Sign::zero) continue;
    if (axis >= 0) return -1;
    axis = k;
  }
  return axis;
}

// Multiplied by a power of two, which leaves the plane as it is, so that the normal is near 1.
std::shared_ptr<const ExactCoefficients> coefficients_of(const Dyadic (&n)[3], const Dyadic& d) {
  std::int64_t most = 0;
  bool any = false;
  for (const Dyadic& k : n) {
    if (k.sign() == Sign::zero) continue;
    most = any ? std::max(most, k.magnitude()) : k.magnitude();
    any = true;
  }
  auto made = std::make_shared<ExactCoefficients>();
  for (int k = 0; k < 3; ++k) made->n[k] = ExactNumber(n[k].scaled(-most));
  made->d = ExactNumber(d.scaled(-most));
  return made;
}

bool as_doubles(const ExactCoefficients& k, PlaneCoefficients& doubles) {
  const Dyadic* exact[] = {&k.n[0].exact(), &k.n[1].exact(), &k.n[2].exact(), &k.d.exact()};
  double* const to[] = {&doubles.a, &doubles.b, &doubles.c, &doubles.d};
  for (int i = 0; i < 4; ++i) {
    *to[i] = exact[i]->nearest();
    if (!std::isfinite(*to[i]) || !(Dyadic(*to[i]) == *exact[i])) return false;
  }
  return true;
}

}  // namespace

GeometryMover::GeometryMover(const Frame& frame) : frame_(std::make_shared<const Frame>(frame)) {
  for (int axis = 0; axis < 3; ++axis) {
    auto direction = std::make_shared<ExactDirection>();
    for (int row = 0; row < 3; ++row) direction->d[row] = frame.entry(row, axis);
    axes_[axis] = std::move(direction);
  }
}

GeometryMover::DirectionPointer GeometryMover::image_of(const ExactDirection& direction) const {
  auto image = std::make_shared<ExactDirection>();
  for (int row = 0; row < 3; ++row) {
    Dyadic sum;
    for (int k = 0; k < 3; ++k) sum += frame_->exact(row, k) * direction.d[k].exact();
    image->d[row] = ExactNumber(std::move(sum));
  }
  return image;
}

void GeometryMover::prepare(const Geometry& geometry) {
  for (const FramePointer& f : geometry.frames) {
    if (frames_.contains(f.get())) continue;
    auto composed = std::make_shared<const Frame>(*frame_ * *f);
    frames_[f.get()] = composed->is_identity() ? nullptr : std::move(composed);
  }
  for (const DirectionPointer& d : geometry.directions)
    if (!directions_.contains(d.get())) directions_[d.get()] = image_of(*d);
}

void GeometryMover::move_given(const Vec3& local, const FramePointer& frame, PointId p,
                               Geometry& to) const {
  Vec3& position = to.positions[p];
  std::uint32_t& how = to.construct[p];
  how = Geometry::explicit_point;
  if (!frame) {
    position = local;
  } else if (!frame->round(local, position)) {
    how = Geometry::moved_point | static_cast<std::uint32_t>(to.moved.size());
    to.moved.push_back({local, to.frames.place(frame)});
  }
}

void GeometryMover::move_points(const Geometry& from, Geometry& to) const {
  to.positions = from.positions;
  to.construct = from.construct;
  to.constructions = from.constructions;
  for (std::size_t i = 0; i < from.positions.size(); ++i) {
    const PointId p(i);
    if (from.is_explicit(p)) {
      move_given(from.position(p), frame_, p, to);
    } else if (from.is_moved(p)) {
      const MovedPoint& known = from.moved_point_of(p);
      move_given(known.local, frames_.at(from.frames[known.frame].get()), p, to);
    }
  }
}

void GeometryMover::move_plane(const Geometry& from, PlaneDefinition& plane, Geometry& to) const {
  using Kind = PlaneDefinition::Kind;
  const auto along = [&](const DirectionPointer& direction) {
    const int axis = axis_along(*direction);
    const PointId a(plane.a), b(plane.b);
    if (axis < 0) {
      plane = PlaneDefinition::along_direction(a, b, to.directions.place(direction));
    } else if (direction->d[axis].exact().sign() == Sign::positive) {
      plane = PlaneDefinition::along_axis(a, b, axis);
    } else {
      plane = PlaneDefinition::along_axis(b, a, axis);
    }
  };
  const auto with = [&](const Dyadic(&n)[3], const Dyadic& d) {
    Dyadic image[3], offset = frame_->determinant() * d;
    for (int row = 0; row < 3; ++row) {
      for (int k = 0; k < 3; ++k) image[row] += frame_->cofactor(row, k) * n[k];
      offset -= image[row] * frame_->exact(row, 3);
    }
    const auto exact = coefficients_of(image, offset);
    if (PlaneCoefficients doubles; as_doubles(*exact, doubles)) {
      to.coefficients.push_back(doubles);
      plane = PlaneDefinition::with_coefficients(
          static_cast<std::uint32_t>(to.coefficients.size() - 1));
    } else {
      to.exact_coefficients.push_back(exact);
      plane = PlaneDefinition::with_exact_coefficients(
          static_cast<std::uint32_t>(to.exact_coefficients.size() - 1));
    }
  };
  switch (plane.kind()) {
    case Kind::three_points:
      return;
    case Kind::along_x:
    case Kind::along_y:
    case Kind::along_z:
      return along(axes_[axis_of(plane.kind())]);
    case Kind::along_direction:
      return along(directions_.at(from.directions[plane.direction()].get()));
    case Kind::coefficients: {
      const PlaneCoefficients& k = from.coefficients[plane.a];
      return with({Dyadic(k.a), Dyadic(k.b), Dyadic(k.c)}, Dyadic(k.d));
    }
    case Kind::exact_coefficients: {
      const ExactCoefficients& k = *from.exact_coefficients[plane.a];
      return with({k.n[0].exact(), k.n[1].exact(), k.n[2].exact()}, k.d.exact());
    }
  }
}

void GeometryMover::move_planes(const Geometry& from, Geometry& to) const {
  to.planes = from.planes;
  for (PlaneDefinition& plane : to.planes) move_plane(from, plane, to);
}

Geometry GeometryMover::operator()(const Geometry& from) const {
  Geometry to;
  move_points(from, to);
  move_planes(from, to);
  if (to.constructions.empty()) return to;
  const Kernel kernel(to);
  for (const PointId p : to.positions.ids())
    if (to.is_constructed(p)) to.positions[p] = kernel.construct(to.construction(p)).position;
  return to;
}

}  // namespace sectile
