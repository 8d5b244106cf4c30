// Where very many vertices are in one place, or very many edges between two places, one of them is
// tested against the faces there, for all.
#pragma once

#include "numbers/id.h"
#include "numbers/table.h"

namespace sectile {

/// Of one patch: what is tested for a vertex or an edge, as a rule itself.
class Tested {
 public:
  bool any() const { return !vertices_.empty() || !edges_.empty(); }
  VertexId operator()(VertexId v) const { return find(vertices_, v); }
  EdgeId operator()(EdgeId e) const { return find(edges_, e); }
  /// Whatever is tested for the first one is now what is tested for the second one.
  void set(VertexId v, VertexId tested) { set(vertices_, v, tested); }
  void set(EdgeId e, EdgeId tested) { set(edges_, e, tested); }

 private:
  template <class Id>
  static Id find(const Table<Id, Id>& table, Id i) {
    while (i.value() < table.size() && table[i].valid()) i = table[i];
    return i;
  }
  template <class Id>
  static void set(Table<Id, Id>& table, Id i, Id tested) {
    i = find(table, i);
    tested = find(table, tested);
    if (i == tested) return;
    if (table.size() <= i.value()) table.resize(i.value() + std::size_t(1));
    table[i] = tested;
  }

  Table<VertexId, VertexId> vertices_;  // invalid: itself
  Table<EdgeId, EdgeId> edges_;
};

}  // namespace sectile
