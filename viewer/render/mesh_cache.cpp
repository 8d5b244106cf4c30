#include "render/mesh_cache.h"

namespace sectile::viewer {
namespace {

void fill(const GlBuffer& buffer, const std::vector<glm::vec3>& values, GLuint attribute) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(glm::vec3)),
               values.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
}

double whole_length(const std::vector<glm::vec3>& ends) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
    sum += static_cast<double>(glm::length(ends[i + 1] - ends[i]));
  return sum;
}

std::unique_ptr<MeshBuffers> upload(const SurfaceMesh& mesh) {
  auto made = std::make_unique<MeshBuffers>();
  glBindVertexArray(made->triangles.id());
  fill(made->positions, mesh.positions, 0);
  fill(made->normals, mesh.normals, 1);
  glBindVertexArray(0);
  made->corners = static_cast<GLsizei>(mesh.positions.size());
  return made;
}

std::unique_ptr<EdgeBuffers> upload(const std::vector<glm::vec3>& ends) {
  auto made = std::make_unique<EdgeBuffers>();
  fill_pulled(made->ends, made->ends_texture, ends, GL_STATIC_DRAW);
  glBindVertexArray(made->hairlines.id());
  glBindBuffer(GL_ARRAY_BUFFER, made->ends.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  made->count = static_cast<GLsizei>(ends.size());
  made->length = whole_length(ends);
  return made;
}

}  // namespace

MeshCache::Entry& MeshCache::entry(const std::shared_ptr<const SurfaceMesh>& mesh) {
  Entry& entry = entries_[mesh.get()];
  // Another mesh may have come to live where a dead one was.
  if (entry.mesh.lock() != mesh) entry = {mesh, nullptr, nullptr, nullptr};
  return entry;
}

const MeshBuffers& MeshCache::buffers(const std::shared_ptr<const SurfaceMesh>& mesh) {
  Entry& entry = this->entry(mesh);
  if (!entry.buffers) entry.buffers = upload(*mesh);
  return *entry.buffers;
}

const EdgeBuffers& MeshCache::hard_edges(const std::shared_ptr<const SurfaceMesh>& mesh) {
  Entry& entry = this->entry(mesh);
  if (!entry.hard) entry.hard = upload(mesh->hard_edges);
  return *entry.hard;
}

const EdgeBuffers& MeshCache::smooth_edges(const std::shared_ptr<const SurfaceMesh>& mesh) {
  Entry& entry = this->entry(mesh);
  if (!entry.smooth) entry.smooth = upload(mesh->smooth_edges);
  return *entry.smooth;
}

void MeshCache::sweep() {
  std::erase_if(entries_, [](const auto& entry) { return entry.second.mesh.expired(); });
}

void fill_pulled(const GlBuffer& buffer, const GlTexture& texture,
                 const std::vector<glm::vec3>& places, GLenum usage) {
  std::vector<glm::vec4> padded;
  padded.reserve(places.size());
  for (const glm::vec3& place : places) padded.emplace_back(place, 1.0f);
  glBindBuffer(GL_TEXTURE_BUFFER, buffer.id());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(padded.size() * sizeof(glm::vec4)),
               padded.data(), usage);
  glBindTexture(GL_TEXTURE_BUFFER, texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_RGBA32F, buffer.id());
}

}  // namespace sectile::viewer
