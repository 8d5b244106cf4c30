#include "boolean/near/nested_faces.h"

#include <atomic>

#include "boolean/collect.h"
#include "numbers/threshold.h"
#include "search/face_corners.h"

namespace sectile {
NestedFaces::NestedFaces(const Workspace& w, const SolidData& a, const SolidData& b,
                         const SlotsOfBoth& slots)
    : w_(w), data_{{&a, &b}} {
  for (const Operand s : both_operands) {
    if (s == Operand::b) first_of_b_ = face_count_;
    for (const std::uint32_t slot : slots[s]) {
      places_.push_back({s, slot, face_count_, {}});
      face_count_ += data_[s]->slot(slot).faces;
    }
  }
  for (Place& place : places_) find_hollow_faces(place);
}

void NestedFaces::find_hollow_faces(Place& place) {
  const Brep& brep = block(place).brep();
  const Geometry& geometry = block(place).geometry();
  std::vector<Vec3> corners;
  for (std::uint32_t f = 0; f < brep.face_count(); ++f) {
    corners.clear();
    const auto loop_ends = collect_corners(
        brep, FaceId(f), [&](PointId p) { corners.push_back(geometry.position(p)); });
    if (!is_hollow(corners, loop_ends)) continue;
    place.hollow.push_back(FaceId(f));
    ++hollow_faces_;
    hollow_corners_ += corners.size();
  }
}

std::optional<FacePairs> NestedFaces::pairs(const CommonHubs& hubs) const {
  // More looks than so many for each piece take longer than all pairs of faces.
  constexpr std::size_t very_many = threshold(64, 8);
  constexpr std::size_t parts_at_least = threshold(64, 2);
  const PieceSearch search(pieces(), labels(hubs));
  const std::vector<FaceId> in_solid = faces_in_solids();
  const std::vector<BoxTree::SelfPart> parts = search.parts(parts_at_least);
  const std::size_t most = very_many * search.pieces();
  std::atomic<std::size_t> looks = 0;
  FacePairs pairs =
      joined(collect<FacePairs>(w_, parts.size(), 1, [&](std::size_t part, auto& out) {
        if (looks > most) return;
        looks += search.for_each_pair(parts[part], most, [&](std::uint32_t i, std::uint32_t j) {
          const auto& [f, g] = std::minmax(i, j);
          if (f < first_of_b_ && g >= first_of_b_) out.push_back({in_solid[f], in_solid[g]});
        });
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
      }));
  if (looks > most) return {};
  return pairs;
}

FacePieces NestedFaces::pieces() const {
  FacePieces all;
  for (const FacePieces& some :
       collect<FacePieces>(w_, places_.size(), 1,
                           [&](std::size_t i, FacePieces&to) { add_pieces(places_[i], to); }))
    all.append(some);
  return all;
}

void NestedFaces::add_pieces(const Place& place, FacePieces& to) const {
  const Brep& brep = block(place).brep();
  const Geometry& geometry = block(place).geometry();
  const auto add_whole = [&](FaceId f) {
    with_outer_corners(brep, geometry, f,
                       [&](auto corners) { to.add(place.first + f.value(), corners); });
  };
  std::vector<PlaneId> planes;
  for (const FaceId f : place.hollow) planes.push_back(brep.plane[f]);
  std::optional<Kernel> kernel;
  if (!place.hollow.empty()) kernel.emplace(geometry, planes);
  std::vector<PointId> corners;
  std::size_t next = 0;
  for (std::uint32_t f = 0; f < brep.face_count(); ++f) {
    if (next == place.hollow.size() || place.hollow[next] != FaceId(f)) {
      add_whole(FaceId(f));
      continue;
    }
    ++next;
    corners.clear();
    const auto loop_ends =
        collect_corners(brep, FaceId(f), [&](PointId p) { corners.push_back(p); });
    to.add_triangles(place.first + f, *kernel, brep.plane[FaceId(f)], corners, loop_ends);
  }
}

// What is in one fan is no pair; of others, those of one solid are none.
std::vector<std::uint32_t> NestedFaces::labels(const CommonHubs& hubs) const {
  std::vector<std::uint32_t> labels(face_count_);
  for (const Place& place : places_) {
    const std::vector<std::uint32_t>* hub_of =
        hubs.empty() ? nullptr : &block(place).tree().hubs().of_face();
    for (std::uint32_t f = 0; f < block(place).face_count(); ++f) {
      const std::uint32_t hub = !hub_of || hub_of->empty() ? Hubs::none : (*hub_of)[f];
      labels[place.first + f] = hub != Hubs::none ? 2 + hubs.fan(place.solid, place.slot, hub)
                                : place.solid == Operand::a ? 0
                                                            : 1;
    }
  }
  return labels;
}

std::vector<FaceId> NestedFaces::faces_in_solids() const {
  std::vector<FaceId> faces(face_count_);
  for (const Place& place : places_)
    for (std::uint32_t f = 0; f < block(place).face_count(); ++f)
      faces[place.first + f] = data_[place.solid]->face(place.slot, FaceId(f));
  return faces;
}

}  // namespace sectile
