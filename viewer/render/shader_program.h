// A vertex and a fragment shader, linked.
#pragma once

#include <glad/gl.h>

#include <glm/glm.hpp>
#include <map>
#include <string>

namespace sectile::viewer {

class ShaderProgram {
 public:
  /// From embedded files; `definitions` are put below the version line of both. Throws
  /// std::runtime_error with the compiler's message.
  ShaderProgram(const std::string& vertex_file, const std::string& fragment_file,
                const std::string& definitions = "");
  ~ShaderProgram();
  ShaderProgram(const ShaderProgram&) = delete;
  ShaderProgram& operator=(const ShaderProgram&) = delete;

  void use() const;
  // Of the program in use. Names that the compiler found unused are ignored.
  void set(const char* name, float value);
  void set(const char* name, int value);
  void set(const char* name, const glm::vec2& value);
  void set(const char* name, const glm::vec3& value);
  void set(const char* name, const glm::vec4& value);
  void set(const char* name, const glm::mat3& value);
  void set(const char* name, const glm::mat4& value);

 private:
  GLint location(const char* name);

  GLuint id_ = 0;
  std::map<std::string, GLint> locations_;
};

}  // namespace sectile::viewer
