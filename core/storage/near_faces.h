// The faces of two blocks that may meet: a pair is asked with its own planes and edges before
// anyone writes it down.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "numbers/threshold.h"
#include "search/four_faces.h"
#include "search/hull.h"
#include "storage/block.h"

namespace sectile {

/// Hulls of the faces of one block that were asked for last.
class HullCache {
 public:
  void start(const Block& block) {
    if (block_ == &block) return;
    block_ = &block;
    face_.assign(size, none);
    hull_.resize(size);
  }
  const Hull& operator[](std::uint32_t face) {
    const std::size_t at = face % size;
    if (face_[at] != face) {
      face_[at] = face;
      hull_[at] = face_hull(block_->brep(), block_->geometry(), FaceId(face));
    }
    return hull_[at];
  }

 private:
  static constexpr std::size_t size = 32;
  static constexpr std::uint32_t none = 0xFFFFFFFFu;
  const Block* block_ = nullptr;
  std::vector<std::uint32_t> face_;  // empty before the first block
  std::vector<Hull> hull_;
};

/// Which pairs of faces of two blocks, or of some faces of each, are not asked for: none.
struct NothingLeftOut {
  bool operator()(std::uint32_t, std::uint32_t) const { return false; }
  bool operator()(std::span<const std::uint32_t>, std::span<const std::uint32_t>) const {
    return false;
  }
};

/// Not for several threads at a time.
class NearFaces {
 public:
  /// Calls visit(face of a, face of b) for all pairs that meet and for few others, but not for
  /// those whose hubs satisfy skip(hub of a, hub of b), and not for those that are left out.
  template <class Visit, class Skip, class LeftOut = NothingLeftOut>
  void operator()(const Block& a, const Block& b, const Visit& visit, const Skip& skip,
                  const LeftOut& left_out = LeftOut()) {
    if (a.brep().face_count() * b.brep().face_count() <= few_pairs) {
      BoxTree::overlaps(
          a.tree(), b.tree(),
          [&](std::uint32_t f, std::uint32_t g) {
            if (!left_out(f, g)) visit(f, g);
          },
          skip, FacesApart(planes_of_few(a, b), planes_of_few(b, a)));
      return;
    }
    if (apart(a.oriented_bounds(), b.oriented_bounds())) return;
    hulls_[0].start(a);
    hulls_[1].start(b);
    BoxTree::overlaps(
        a.tree(), b.tree(),
        [&](std::uint32_t f, std::uint32_t g) {
          if (!left_out(f, g) && !apart(hulls_[0][f], hulls_[1][g])) visit(f, g);
        },
        skip, Apart(a, b, left_out, looks_));
  }
  /// How often two nodes, or a face beside a leaf, were looked at in large blocks so far?
  std::size_t looks() const { return looks_; }

 private:
  using Planes = std::span<const FourFaces>;
  // To make them for many takes longer than to ask the planes of few, each of which is large beside
  // what it meets.
  static Planes planes(const Block& of, const Block& beside) {
    if (!are_few(of) && are_few(beside)) return {};
    return of.tree().fours(of.brep(), of.geometry());
  }
  static Planes planes_of_few(const Block& of, const Block& beside) {
    return are_few(of) && !are_few(beside) ? planes(of, beside) : Planes();
  }

  // By the planes of faces, where they are known.
  class FacesApart : public BoxTree::NothingApart {
   public:
    FacesApart(Planes of_a, Planes of_b) : of_a_(of_a), of_b_(of_b) {}

    unsigned near_in_a(std::uint32_t leaf, unsigned items, const Box& box) const {
      return near(of_a_, leaf, items, box);
    }
    unsigned near_in_b(std::uint32_t leaf, unsigned items, const Box& box) const {
      return near(of_b_, leaf, items, box);
    }
    unsigned near_item(std::uint32_t p, unsigned i, std::uint32_t q, unsigned items) const {
      if (of_a_.empty() || of_b_.empty()) return items;
      return items & ~of_a_[p].apart_from(of_b_[q], i);
    }

   private:
    static unsigned near(Planes of, std::uint32_t leaf, unsigned items, const Box& box) {
      return items == 0 || of.empty() ? items : items & ~of[leaf].apart_from(box);
    }
    Planes of_a_, of_b_;
  };

  // By oriented boxes, too, if one of the blocks has them; and two leaves that are left out.
  template <class LeftOut>
  class Apart : public FacesApart {
   public:
    Apart(const Block& a, const Block& b, const LeftOut& left_out, std::size_t& looks)
        : FacesApart(planes(a, b), planes(b, a)),
          a_(a.tree()),
          b_(b.tree()),
          left_out_(left_out),
          looks_(looks),
          by_nodes_(a.tree(), a.tree().oriented(a.brep(), a.geometry()), b.tree(),
                    b.tree().oriented(b.brep(), b.geometry())) {}

    bool nodes(BoxTree::Node p, BoxTree::Node q) const {
      ++looks_;
      return by_nodes_.nodes(p, q) || is_left_out(p, q);
    }
    unsigned near_item(std::uint32_t p, unsigned i, std::uint32_t q, unsigned items) const {
      ++looks_;
      return FacesApart::near_item(p, i, q, items);
    }

   private:
    bool is_left_out(BoxTree::Node p, BoxTree::Node q) const {
      return p.level == 0 && q.level == 0 && left_out_(a_.items(p), b_.items(q));
    }

    const BoxTree &a_, &b_;
    const LeftOut& left_out_;
    std::size_t& looks_;
    OrientedApart by_nodes_;
  };

  // So few are tested exactly in no more time.
  static constexpr std::size_t few_pairs = threshold(1024, 1);
  static bool are_few(const Block& block) {
    return block.brep().face_count() <= BoxTree::width * BoxTree::width;
  }

  HullCache hulls_[2];
  std::size_t looks_ = 0;
};

}  // namespace sectile
