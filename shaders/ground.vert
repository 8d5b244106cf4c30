#version 330 core
// The square of the ground around the camera's target, or, seen from the side, of the plane across
// the view. Places are relative to `centre`, which lies on a grid point, so that single precision
// is enough far from the origin.
uniform mat4 to_clip;
uniform vec3 base;      // a point of the plane; the other two are its axes
uniform vec3 first;
uniform vec3 second;
uniform bool backmost;
uniform vec2 centre;
uniform float reach;
uniform float depth_shift;

out vec2 place;

void main() {
  place = vec2(gl_VertexID % 2 == 0 ? -reach : reach, gl_VertexID / 2 == 0 ? -reach : reach);
  vec2 at = centre + place;
  gl_Position = to_clip * vec4(base + at.x * first + at.y * second, 1.0);
  gl_Position.z += depth_shift * gl_Position.w;
  if (backmost) gl_Position.z = 0.0;
}
