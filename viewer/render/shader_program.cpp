#include "render/shader_program.h"

#include <glm/gtc/type_ptr.hpp>
#include <stdexcept>
#include <vector>

#include "render/embedded.h"

namespace sectile::viewer {
namespace {

std::string source_of(const std::string& file, const std::string& definitions) {
  std::string text(embedded_file(file));
  text.insert(text.find('\n') + 1, definitions);
  return text;
}

GLuint compile(GLenum kind, const std::string& file, const std::string& definitions) {
  const std::string text = source_of(file, definitions);
  const char* start = text.c_str();
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &start, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good) return shader;
  std::vector<char> message(4096);
  glGetShaderInfoLog(shader, static_cast<GLsizei>(message.size()), nullptr, message.data());
  glDeleteShader(shader);
  throw std::runtime_error("shader " + file + ": " + message.data());
}

}  // namespace

ShaderProgram::ShaderProgram(const std::string& vertex_file, const std::string& fragment_file,
                             const std::string& definitions)
    : id_(glCreateProgram()) {
  const GLuint vertex = compile(GL_VERTEX_SHADER, vertex_file, definitions);
  const GLuint fragment = compile(GL_FRAGMENT_SHADER, fragment_file, definitions);
  for (const GLuint shader : {vertex, fragment}) {
    glAttachShader(id_, shader);
    glDeleteShader(shader);  // goes with the program
  }
  glLinkProgram(id_);
  GLint good = 0;
  glGetProgramiv(id_, GL_LINK_STATUS, &good);
  if (good) return;
  std::vector<char> message(4096);
  glGetProgramInfoLog(id_, static_cast<GLsizei>(message.size()), nullptr, message.data());
  throw std::runtime_error("shaders " + vertex_file + " and " + fragment_file + ": " +
                           message.data());
}

ShaderProgram::~ShaderProgram() {
  glDeleteProgram(id_);
}

void ShaderProgram::use() const {
  glUseProgram(id_);
}

GLint ShaderProgram::location(const char* name) {
  const auto [place, added] = locations_.try_emplace(name, -1);
  if (added) place->second = glGetUniformLocation(id_, name);
  return place->second;
}

void ShaderProgram::set(const char* name, float value) {
  glUniform1f(location(name), value);
}
void ShaderProgram::set(const char* name, int value) {
  glUniform1i(location(name), value);
}
void ShaderProgram::set(const char* name, const glm::vec2& value) {
  glUniform2fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec3& value) {
  glUniform3fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::vec4& value) {
  glUniform4fv(location(name), 1, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat3& value) {
  glUniformMatrix3fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}
void ShaderProgram::set(const char* name, const glm::mat4& value) {
  glUniformMatrix4fv(location(name), 1, GL_FALSE, glm::value_ptr(value));
}

}  // namespace sectile::viewer
