#include "import/triangles/chunk_reader.h"

#include <atomic>

namespace sectile {

bool ChunkReader::read(const TriangleMesh& mesh, std::uint32_t chunk,
                       std::span<std::uint32_t> marks, TriangleChunk& result) {
  result_ = &result;
  first_ = mesh.chunk_begin(chunk);
  corners_ = static_cast<std::uint16_t>(3 * (mesh.chunk_end(chunk) - first_));
  gather(mesh);
  // All chunks have one origin for their volumes.
  if (!measure(mesh.position(PointId(mesh.input_corners[0]))) || !match()) return false;
  number_half_edges();
  if (!has_plain_vertices()) return false;
  find_flat_edges();
  add_triangles(mesh);
  find_pieces();
  add_borders();
  add_chords();
  if (!marks.empty()) mark_points(marks);
  return true;
}

// Step by step, so that many places in memory are waited for at a time.
void ChunkReader::gather(const TriangleMesh& mesh) {
  for (std::uint32_t t = 0; 3 * t < corners_; ++t)
    for (std::uint32_t k = 0; k < 3; ++k)
      input_[3 * t + k] = mesh.input_corners[3 * std::size_t(mesh.source[first_ + t]) + k];
  numbers_.clear();
  std::uint16_t count = 0;
  for (std::uint16_t i = 0; i < corners_; ++i) {
    const std::uint16_t vertex = numbers_.find_or_add(input_[i], count);
    vertex_[i] = vertex;
    point_[count] = input_[i];  // written again, unless it is new
    some_corner_[count] = i;
    count = static_cast<std::uint16_t>(count + (vertex == count));
  }
  for (std::uint16_t v = 0; v < count; ++v) position_[v] = mesh.position(PointId(point_[v]));
  vertices_ = count;
}

// False if a triangle may have no area.
bool ChunkReader::measure(const Vec3& origin) {
  bool all_bent = true;
  for (std::uint16_t i = 0; i < corners_; i = static_cast<std::uint16_t>(i + 3)) {
    NormalOfThree& normal = normal_[i / 3u];
    normal = NormalOfThree(position(i), position(next(i)), position(prev(i)));
    all_bent = all_bent && normal.clearly_bent();
    result_->volume.add(origin, normal);
  }
  return all_bent;
}

// Both half-edges of an edge are mates of each other; what is alone has none.
bool ChunkReader::match() {
  lines_.clear();
  unsigned wrong = 0;
  const auto meet = [&](std::uint16_t i, std::uint16_t from, std::uint16_t to) {
    const std::uint16_t other = lines_.meet(i, from, to);
    mate_[i] = other;
    mate_[other] = i;
    wrong |= unsigned(other != none) & unsigned(vertex_[other] != to);
    wrong |= unsigned(other == ChunkLines::full);
  };
  for (std::uint16_t i = 0; i < corners_; i = static_cast<std::uint16_t>(i + 3)) {
    const std::uint16_t a = vertex_[i], b = vertex_[i + 1u], c = vertex_[i + 2u];
    meet(i, a, b);
    meet(static_cast<std::uint16_t>(i + 1), b, c);
    meet(static_cast<std::uint16_t>(i + 2), c, a);
  }
  return wrong == 0;
}

void ChunkReader::number_half_edges() {
  unsigned borders = 0, inner = 0;
  for (std::uint16_t i = 0; i < corners_; ++i) {
    border_[borders] = i;
    borders += mate_[i] == none;
  }
  unsigned next_border = 0, next_inner = 2 * borders;
  for (std::uint16_t i = 0; i < corners_; ++i) {
    const unsigned mate = mate_[i], is_border = mate == none,
                   is_first = unsigned(mate > i) & ~is_border;
    const unsigned choices[] = {half_edge_[mate] + 1u, next_inner, next_border};
    half_edge_[i] = static_cast<std::uint16_t>(choices[2 * is_border + is_first]);
    next_border += 2 * is_border;
    next_inner += 2 * is_first;
    inner_[inner] = i;
    inner += is_first;
  }
  border_count_ = static_cast<std::uint16_t>(borders);
  inner_count_ = static_cast<std::uint16_t>(inner);
}

// One cycle around each vertex that is not on the border, and around others nothing but what begins
// at a border: its triangles follow each other up to the next border.
bool ChunkReader::has_plain_vertices() {
  std::fill_n(on_border_.begin(), vertices_, std::uint8_t(0));
  unsigned met = 0, inside = 0;
  for (std::uint16_t b = 0; b < border_count_; ++b) {
    on_border_[vertex_[border_[b]]] = on_border_[vertex_[next(border_[b])]] = 1;
    std::uint16_t last = prev(border_[b]);
    for (++met; mate_[last] != none; ++met) last = prev(mate_[last]);
    around_[b] = half_edge_[last] / 2;
  }
  for (std::uint16_t v = 0; v < vertices_; ++v) {
    if (on_border_[v] != 0) continue;
    ++inside;
    const std::uint16_t first = some_corner_[v];
    std::uint16_t corner = first;
    do {
      corner = mate_[prev(corner)];
      ++met;
    } while (corner != first);
  }
  result_->points_within = inside;
  return met == corners_;
}

void ChunkReader::find_flat_edges() {
  for (std::uint16_t e = 0; e < inner_count_; ++e) {
    const std::uint16_t i = inner_[e];
    const Vec3& d = position(prev(mate_[i]));
    if (normal_[i / 3u].clearly_off(d)) continue;
    if (in_one_plane(position(i), position(next(i)), position(prev(i)), d))
      result_->flat.insert(result_->flat.end(), {i / 3u, mate_[i] / 3u});
  }
}

void ChunkReader::add_triangles(const TriangleMesh& mesh) {
  CompactTriangles& made = result_->triangles;
  made.half_edge_count = 2u * (border_count_ + inner_count_);
  made.border.reserve(border_count_);
  for (std::uint16_t b = 0; b < border_count_; ++b)
    made.border.push_back({border_[b], vertex_[border_[b]], vertex_[next(border_[b])]});
  made.positions.assign(position_.begin(), position_.begin() + vertices_);
  made.triangles.resize(corners_ / 3u);
  for (std::uint16_t i = 0; i < corners_; i = static_cast<std::uint16_t>(i + 3))
    made.triangles[i / 3u] = {{vertex_[i], vertex_[i + 1u], vertex_[i + 2u]},
                              {half_edge_[i], half_edge_[i + 1u], half_edge_[i + 2u]},
                              mesh.source[first_ + i / 3u]};
}

// Most triangles have an earlier neighbour, with which they hang together.
void ChunkReader::find_pieces() {
  const auto count = static_cast<std::uint16_t>(corners_ / 3);
  for (std::uint16_t t = 0; t < count; ++t) piece_[t] = t;
  for (std::uint16_t e = 0; e < inner_count_; ++e) piece_[mate_[inner_[e]] / 3u] = inner_[e] / 3u;
  std::uint16_t pieces = 0;
  for (std::uint16_t t = 0; t < count; ++t) {
    pieces = static_cast<std::uint16_t>(pieces + (piece_[t] == t));
    piece_[t] = piece_[piece_[t]];
  }
  const auto first = [&](std::uint16_t t) {
    while (piece_[t] != t) t = piece_[t] = piece_[piece_[t]];
    return t;
  };
  for (std::uint16_t e = 0; e < inner_count_ && pieces > 1; ++e) {
    const std::uint16_t s = first(inner_[e] / 3), t = first(mate_[inner_[e]] / 3);
    if (s == t) continue;
    piece_[std::max(s, t)] = std::min(s, t);
    --pieces;
  }
  result_->triangles.piece_count = pieces;
  if (pieces == 1) return;
  std::vector<std::uint8_t>& piece = result_->triangles.piece;
  piece.resize(count);
  std::uint8_t number = 0;
  for (std::uint16_t t = 0; t < count; ++t) piece[t] = piece_[t] == t ? number++ : piece[first(t)];
}

void ChunkReader::add_borders() {
  result_->borders.resize(border_count_);
  for (std::uint16_t b = 0; b < border_count_; ++b) {
    const std::uint16_t corner = border_[b];
    result_->borders[b] = {point(corner), point(next(corner)), point(prev(corner)), corner,
                           around_[b]};
  }
}

void ChunkReader::add_chords() {
  std::array<std::uint64_t, most> chords;
  std::size_t count = 0;
  for (std::uint16_t e = 0; e < inner_count_; ++e) {
    const std::uint16_t from = vertex_[inner_[e]], to = vertex_[next(inner_[e])];
    if ((on_border_[from] & on_border_[to]) != 0)
      chords[count++] = line_between(point_[from], point_[to]);
  }
  result_->chords.assign(chords.begin(), chords.begin() + count);
}

void ChunkReader::mark_points(std::span<std::uint32_t> marks) const {
  for (std::uint16_t v = 0; v < vertices_; ++v)
    if (on_border_[v] == 0)
      std::atomic_ref(marks[point_[v]]).store(within, std::memory_order_relaxed);
}

}  // namespace sectile
