#version 330 core
// The part of the ground that has a shadow on it.
uniform mat4 to_clip;
uniform vec3 low;
uniform vec2 extent;
uniform float depth_shift;
out vec2 place;

void main() {
  place = vec2(gl_VertexID % 2, gl_VertexID / 2);
  gl_Position = to_clip * vec4(low.xy + place * extent, low.z, 1.0);
  gl_Position.z += depth_shift * gl_Position.w;
}
