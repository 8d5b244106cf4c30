#version 330 core
// The square of the ground around the camera's target. Places are relative to `centre`, which lies
// on a grid point, so that single precision is enough far from the origin.
uniform mat4 to_clip;
uniform vec2 centre;
uniform float reach;
uniform float depth_shift;

out vec2 place;

void main() {
  place = vec2(gl_VertexID % 2 == 0 ? -reach : reach, gl_VertexID / 2 == 0 ? -reach : reach);
  gl_Position = to_clip * vec4(centre + place, 0.0, 1.0);
  gl_Position.z += depth_shift * gl_Position.w;
}
