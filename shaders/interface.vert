#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 texture_place;
layout(location = 2) in vec4 vertex_colour;
uniform vec2 origin;
uniform vec2 size;
out vec2 at;
out vec4 colour;

void main() {
  at = texture_place;
  colour = vertex_colour;
  vec2 p = (position - origin) / size;
  gl_Position = vec4(p.x * 2.0 - 1.0, 1.0 - p.y * 2.0, 0.0, 1.0);
}
