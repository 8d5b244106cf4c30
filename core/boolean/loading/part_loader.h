// Loads some faces of a solid into a patch, on all cores.
//
// The loaded edges are numbered as in gluing: each by the first loaded face that has it, in the
// order of these faces. So runs of faces are counted first, then numbered, then made beside each
// other.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "boolean/patch.h"
#include "numbers/unset_vector.h"
#include "storage/geometry_loader.h"

namespace sectile {

class PartLoader {
 public:
  /// As load_patch().
  PartLoader(const SolidData& solid, const std::vector<FaceId>& faces, Geometry& geometry,
             std::size_t more_edges, std::vector<FarLoops> far_loops);

  Patch take() { return std::move(patch_); }

 private:
  // A half-edge of the solid.
  struct Source {
    std::uint32_t slot;
    HalfEdgeId h;  // in the slot's block
  };
  // A half-edge of a loaded face, the first one of its edge that is loaded; the other one.
  struct First {
    HalfEdgeId h;
    SolidData::Neighbour mate;
    bool is_open;  // the other one is not loaded
  };
  // Some loaded faces of a slot, one after the other.
  struct Run {
    std::uint32_t near;         // of its slot
    std::uint32_t first, last;  // of the faces
    std::vector<First> edges;   // numbered by its faces, in their order
    std::uint32_t loops = 0, first_edge = 0, first_loop = 0;
  };
  // A slot of which faces are loaded.
  struct NearSlot {
    std::uint32_t slot;
    const Slot* of_solid;
    FarLoops* far;                     // of its one face, if it has some
    std::vector<std::uint32_t> place;  // per face of the block: the loaded face, or `none`
    UnsetVector<HalfEdgeId> made;      // per half-edge of the block, if it is loaded
    std::unique_ptr<GeometryLoader> geometry;
  };
  static constexpr std::uint32_t none = 0xFFFFFFFFu;

  void divide_into_runs();
  template <class Body>
  void for_each_run(const Body& body);

  template <class Visit>
  void for_each_loop(const Run& run, const Visit& visit) const;
  std::uint32_t loaded_face(const SolidData::Neighbour& n) const;
  void count(Run& run);
  void make_room(std::size_t more_edges);
  void number_edges(const Run& run);
  void make_faces(const Run& run);
  void make_loop(const NearSlot& near, LoopId there, LoopId here);
  static bool begins_with(const Source& first, const Source& second);

  void load_planes_of_faces();
  void load_planes_of_edges();
  void close_ends();
  void make_vertices();
  GeometryLoader& geometry(std::uint32_t slot, std::size_t expected);

  const SolidData& solid_;
  const std::vector<FaceId>& faces_;
  Geometry& to_;
  Patch patch_;
  std::vector<std::uint32_t> near_of_slot_;  // or `none`
  std::vector<NearSlot> near_;
  std::vector<Run> runs_;
  std::vector<std::unique_ptr<GeometryLoader>> beyond_;  // per slot of which no face is loaded
  UnsetVector<Source> source_;                           // per loaded half-edge
};

}  // namespace sectile
