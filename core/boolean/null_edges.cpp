#include "boolean/null_edges.h"

#include "sectile/errors.h"
#include "topology/euler.h"

namespace sectile {
namespace {

class SiteSplitter {
 public:
  explicit SiteSplitter(Workspace& w) : w_(w) {}

  void run(Site& site) {
    site_ = &site;
    brep_ = &w_.patch[site.solid].brep;
    if (site.entity.is_face())
      split_face();
    else
      split_vertex();
  }

 private:
  CutEnd& end_of(std::uint32_t i) { return w_.cut_ends[site_->first_end + i]; }

  // The first null edge is an inner loop of the face; further ones extend it.
  void split_face() {
    const HalfEdgeId out = Euler(*brep_).mevvr(site_->entity.face(), w_.point(site_->place));
    site_->vertex = brep_->from(out);
    adopt(out);
    extend_chain(out, site_->end_count);
  }

  // The last cut in counter-clockwise order comes before all other edges: what lies between it and
  // the first one stays with the old vertex.
  void split_vertex() {
    const std::uint32_t k = site_->end_count;
    if (k == 1) {
      end_of(0).first = end_of(0).corner;
      return;
    }
    after_.clear();
    for (std::uint32_t i = 0; i < k; ++i) after_.push_back(brep_->around(end_of(i).corner));
    const HalfEdgeId stays = after_[k - 1];
    HalfEdgeId end = stays, first_out;
    for (std::uint32_t i = 0; i + 1 < k; ++i) {
      // The run after cut i and all further ones move on.
      const bool moves = end_of(i).corner != end_of(k - 1).corner;
      const HalfEdgeId out = Euler(*brep_).mev(moves ? after_[i] : end, end);
      adopt(out);
      if (i == 0) first_out = out;
      end = Brep::twin(out);
      end_of(i).first = end_of(i).last = end;
      last_out_ = out;
    }
    end_of(k - 1).first = first_out;
    end_of(k - 1).last = last_out_;
  }

  // `out` is the first null edge, in a loop of its own. Cut 0 faces its twin; the last cut faces
  // the whole chain.
  void extend_chain(HalfEdgeId out, std::uint32_t k) {
    last_out_ = out;
    HalfEdgeId end = Brep::twin(out);
    end_of(0).first = end_of(0).last = k == 1 ? out : end;
    for (std::uint32_t i = 1; i + 1 < k; ++i) {
      last_out_ = Euler(*brep_).mev(end, end);
      adopt(last_out_);
      end = Brep::twin(last_out_);
      end_of(i).first = end_of(i).last = end;
    }
    if (k > 1) {
      end_of(k - 1).first = out;
      end_of(k - 1).last = last_out_;
    }
  }

  void adopt(HalfEdgeId made) {
    Patch& patch = w_.patch[site_->solid];
    patch.side_plane.resize(brep_->half_edge_count());
    patch.half_edge_in_solid.resize(brep_->half_edge_count());
    w_.null_edges.push_back({site_->solid, Brep::edge_of(made)});
  }

  Workspace& w_;
  Site* site_ = nullptr;
  Brep* brep_ = nullptr;
  HalfEdgeId last_out_;
  std::vector<HalfEdgeId> after_;  // the edge counter-clockwise of each cut
};

}  // namespace

void insert_null_edges(Workspace& w) {
  SiteSplitter splitter(w);
  for (Site& site : w.sites) {
    w.check_cancelled();
    splitter.run(site);
  }
}

}  // namespace sectile
