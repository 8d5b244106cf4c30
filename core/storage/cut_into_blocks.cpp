#include "storage/cut_into_blocks.h"

#include <algorithm>
#include <numeric>

#include "numbers/none.h"
#include "parallel/parallel.h"
#include "search/curve_groups.h"
#include "search/curve_order.h"
#include "search/face_tree.h"
#include "storage/block_of_faces.h"
#include "topology/touching_vertices.h"

namespace sectile {
namespace {

constexpr std::size_t corners_of_a_block = 4096;

// Faces in the order of a curve that fills space, in groups.
class Groups {
 public:
  explicit Groups(const PartToCut& part)
      : part_(part), is_alone_(part.brep.face_count()), of_face_(part.brep.face_count(), none) {
    for (const FaceId f : part.alone) is_alone_[f.value()] = true;
    const std::vector<std::uint64_t> keys = keys_in_order();
    for (std::size_t from = 0, to; from < keys.size(); from = to) {
      for (to = from + 1; to < keys.size() && shell(face(keys[to])) == shell(face(keys[from]));)
        ++to;
      add_shell(std::span(keys).subspan(from, to - from));
    }
  }

  std::size_t count() const { return end_.size() - 1; }
  std::span<const FaceId> operator[](std::size_t g) const {
    return std::span(faces_).subspan(end_[g], end_[g + 1] - end_[g]);
  }
  /// None for faces that stand for what is outside.
  std::uint32_t of(FaceId f) const { return of_face_[f.value()]; }

 private:
  std::size_t corners_of(FaceId f) const {
    std::size_t corners = 0;
    for_each_in_face(part_.brep, f, [&](HalfEdgeId) { ++corners; });
    return corners;
  }

  static std::uint32_t face(std::uint64_t key) { return static_cast<std::uint32_t>(key); }
  std::uint32_t shell(std::uint32_t f) const { return part_.shell.empty() ? 0 : part_.shell[f]; }

  // A small shell stays in one block.
  void add_shell(std::span<const std::uint64_t> keys) {
    std::vector<std::uint32_t> ends;
    if (keys.size() <= most_faces_of_a_block)
      ends.push_back(static_cast<std::uint32_t>(keys.size()));
    else
      add_groups_along_curve(keys, few_faces, faces_of_a_block, 0, ends);
    std::size_t from = 0;
    for (const std::uint32_t end : ends) {
      std::size_t corners = 0;
      for (; from < end; ++from) {
        const FaceId f(face(keys[from]));
        const std::size_t more = room_for(f);
        if (corners > 0 && corners + more > corners_of_a_block) {
          close();
          corners = 0;
        }
        corners += more;
        faces_.push_back(f);
        of_face_[f.value()] = static_cast<std::uint32_t>(end_.size() - 1);
      }
      close();
    }
  }
  // In corners: all of a block for a face that is alone.
  std::size_t room_for(FaceId f) const {
    const std::size_t corners = corners_of(f);
    return is_alone_[f.value()] || corners >= corners_of_a_large_face
               ? std::max(corners, corners_of_a_block)
               : corners;
  }
  void close() { end_.push_back(static_cast<std::uint32_t>(faces_.size())); }

  std::vector<std::uint32_t> sizes_of_shells() const {
    std::vector<std::uint32_t> size(1, 0);
    for (const std::uint32_t s : part_.shell) {
      if (s >= size.size()) size.resize(s + 1, 0);
      ++size[s];
    }
    return size;
  }

  // Shell by shell, along the curve.
  std::vector<std::uint64_t> keys_in_order() const {
    const Brep& brep = part_.brep;
    std::vector<Box> boxes(brep.face_count());
    parallel::loop(parallel::Range<std::size_t>(0, boxes.size(), 2048), [&](const auto& range) {
      for (std::size_t f = range.begin(); f < range.end(); ++f)
        if (is_real(f)) boxes[f] = face_box(brep, part_.geometry, FaceId(f));
    });
    Box all;
    for (const Box& b : boxes) all.add(b);
    std::vector<std::uint32_t> at = sizes_of_shells();
    std::exclusive_scan(at.begin(), at.end(), at.begin(), 0u);
    std::vector<std::uint64_t> keys(brep.face_count());
    std::size_t count = 0;
    for (const std::uint64_t key :
         keys_along_curve(boxes.size(), all, [&](std::size_t i) { return boxes[i]; })) {
      if (!is_real(face(key))) continue;
      keys[at[shell(face(key))]++] = key;
      ++count;
    }
    keys.resize(count);
    return keys;
  }
  bool is_real(std::size_t f) const { return part_.brep.kind_of(FaceId(f)) == FaceKind::real; }

  const PartToCut& part_;
  std::vector<bool> is_alone_;
  std::vector<FaceId> faces_;
  std::vector<std::uint32_t> end_ = {0}, of_face_;
};

class Cutter {
 public:
  explicit Cutter(const PartToCut& part)
      : part_(part),
        brep_(part.brep),
        groups_(part),
        touching_(touching_vertices(part.brep)),
        links_(groups_.count()),
        local_(brep_.half_edge_count()),
        made_{{}, std::vector<BorderEdge>(part.outside.size()), {}} {
    blocks_.reserve(groups_.count());
    for (std::size_t g = 0; g < groups_.count(); ++g)
      blocks_.emplace_back(brep_, part.geometry, groups_[g], touching_, local_);
  }

  CutPart run() {
    for_each_group([&](std::size_t g) {
      blocks_[g].number_edges([&](HalfEdgeId h) { return group_beyond(h) != g; });
    });
    for_each_group([&](std::size_t g) { blocks_[g].fill(); });
    for_each_group([&](std::size_t g) { add_links(g); });
    for (std::size_t g = 0; g < blocks_.size(); ++g)
      made_.slots.push_back({blocks_[g].block(), std::move(links_[g])});
    for (const FaceId f : part_.alone) made_.alone.push_back(part_.places(groups_.of(f)));
    return std::move(made_);
  }

 private:
  template <class Body>
  void for_each_group(const Body& body) const {
    if (groups_.count() < 4 && brep_.half_edge_count() < many_half_edges) {
      for (std::size_t g = 0; g < groups_.count(); ++g) body(g);
    } else {
      parallel::loop(0, groups_.count(), body);
    }
  }

  // Groups of few faces, too, may have very many corners.
  static constexpr std::size_t many_half_edges = 4 * corners_of_a_block;

  std::uint32_t group_beyond(HalfEdgeId h) const {
    return groups_.of(brep_.face_of(Brep::twin(h)));
  }

  BorderEdge border_edge(std::size_t g, HalfEdgeId h) const {
    const HalfEdgeId here = local_[h.value()];
    const Block& block = *blocks_[g].block();
    return {part_.places(g), here.value() / 2, block.piece_at(here)};
  }

  void add_links(std::size_t g) {
    const std::vector<HalfEdgeId>& leaving = blocks_[g].leaving();
    if (leaving.empty()) return;
    std::vector<BorderLink> links(leaving.size());
    for (const HalfEdgeId h : leaving) {
      const BorderEdge mine = border_edge(g, h);
      BorderEdge other;
      if (const std::uint32_t beyond = group_beyond(h); beyond != none) {
        other = border_edge(beyond, Brep::twin(h));
      } else {
        other = part_.outside[Brep::edge_of(h).value()];
        made_.outside[Brep::edge_of(h).value()] = mine;
      }
      links[mine.border] = {static_cast<std::int32_t>(other.slot - mine.slot), other.border,
                            other.piece};
    }
    links_[g] = std::make_shared<const BorderLinks>(std::move(links));
  }

  const PartToCut& part_;
  const Brep& brep_;
  Groups groups_;
  std::vector<VertexId> touching_;
  std::vector<BlockOfFaces> blocks_;
  std::vector<std::shared_ptr<const BorderLinks>> links_;
  std::vector<HalfEdgeId> local_;  // per half-edge: in its face's block
  CutPart made_;
};

}  // namespace

CutPart cut_into_blocks(const PartToCut& part) {
  return Cutter(part).run();
}

}  // namespace sectile
