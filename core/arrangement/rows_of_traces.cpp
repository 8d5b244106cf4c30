#include "arrangement/rows_of_traces.h"

#include <algorithm>
#include <span>
#include <tuple>

#include "numbers/threshold.h"
#include "search/edges_by_line.h"
#include "search/free_stretches.h"
#include "search/places_on_line.h"

namespace sectile::arrangement {
namespace {

// Fewer are not worth looking at.
constexpr std::size_t many_edges = threshold(24, 1);

std::vector<PointId> ends_of(const std::vector<Piece>& traces) {
  std::vector<PointId> ends;
  for (const Piece& t : traces) ends.insert(ends.end(), {t.from, t.to});
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  return ends;
}

// Of several planes across, each stretch gets the first.
void add_stretches(const Kernel& kernel, std::vector<Piece> row, std::vector<Piece>& result) {
  const std::vector<PointId> ends = ends_of(row);
  const PlacesOnLine places(kernel, ends);
  std::sort(row.begin(), row.end(),
            [](const Piece& a, const Piece& b) { return a.across < b.across; });
  std::vector<PlaneId> across(places.count());  // none on a stretch without a trace
  FreeStretches free(places.count());
  for (const Piece& t : row) {
    const auto [low, high] = std::minmax({places.of(t.from), places.of(t.to)});
    free.take(static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(high),
              [&](std::uint32_t k) { across[k] = t.across; });
  }
  for (std::size_t k = 0; k + 1 < places.count(); ++k) {
    if (!across[k].valid()) continue;
    const auto [from, to] = std::minmax({places.at(k), places.at(k + 1)});
    result.push_back({from, to, across[k], none});
  }
}

// Of one row.
void add_joined(const Kernel& kernel, std::span<const Piece> row, std::vector<Piece>& result) {
  const PlacesOnLine places(kernel, ends_of({row.begin(), row.end()}));
  struct Stretch {
    std::size_t low, high;
    PlaneId across;
  };
  std::vector<Stretch> stretches;
  for (const Piece& t : row) {
    const auto [low, high] = std::minmax({places.of(t.from), places.of(t.to)});
    stretches.push_back({low, high, t.across});
  }
  std::sort(stretches.begin(), stretches.end(), [](const Stretch& a, const Stretch& b) {
    return std::tie(a.low, a.high, a.across) < std::tie(b.low, b.high, b.across);
  });
  for (std::size_t first = 0, last; first < stretches.size(); first = last) {
    std::size_t high = stretches[first].high;
    for (last = first + 1; last < stretches.size() && stretches[last].low <= high; ++last)
      high = std::max(high, stretches[last].high);
    const auto [from, to] = std::minmax({places.at(stretches[first].low), places.at(high)});
    result.push_back({from, to, stretches[first].across, none, row.front().row});
  }
}

}  // namespace

std::vector<Piece> take_rows(const Kernel& kernel, std::vector<Piece>& traces) {
  const auto first = std::stable_partition(traces.begin(), traces.end(),
                                           [](const Piece& t) { return t.row == none; });
  std::vector<Piece> rows(first, traces.end()), joined;
  traces.erase(first, traces.end());
  std::ranges::stable_sort(rows, {}, &Piece::row);
  for (std::size_t from = 0, to; from < rows.size(); from = to) {
    for (to = from + 1; to < rows.size() && rows[to].row == rows[from].row;) ++to;
    add_joined(kernel, std::span<const Piece>(rows).subspan(from, to - from), joined);
  }
  return joined;
}

void divide_rows(const Kernel& kernel, std::vector<Piece>& traces) {
  if (traces.size() < many_edges) return;
  const std::vector<PointId> ends = ends_of(traces);
  const auto number = [&](PointId p) {
    return static_cast<std::uint32_t>(std::lower_bound(ends.begin(), ends.end(), p) - ends.begin());
  };
  std::vector<PointPair> edges;
  for (const Piece& t : traces) edges.push_back({number(t.from), number(t.to)});
  std::vector<std::uint8_t> in_row(traces.size(), 0);
  std::vector<Piece> stretches;
  for (const EdgesOfLine& line : edges_by_line(kernel, ends, edges)) {
    if (line.edges.size() < many_edges || line.beside < 2 * line.edges.size()) continue;
    std::vector<Piece> row;
    for (const PointPair& edge : line.edges) {
      const auto at = std::lower_bound(edges.begin(), edges.end(), edge) - edges.begin();
      in_row[static_cast<std::size_t>(at)] = 1;
      row.push_back(traces[static_cast<std::size_t>(at)]);
    }
    add_stretches(kernel, std::move(row), stretches);
  }
  if (stretches.empty()) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < traces.size(); ++i)
    if (in_row[i] == 0) traces[kept++] = traces[i];
  traces.resize(kept);
  traces.insert(traces.end(), stretches.begin(), stretches.end());
}

}  // namespace sectile::arrangement
