#version 330 core
// Triangles with normals of their own or, where the surface is bent, shared ones.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 model_to_clip;
uniform vec4 kept_side;    // a plane in model coordinates; its negative side is cut away
uniform float depth_shift; // keeps coplanar surfaces apart, in a fixed order

out vec3 model_normal;

invariant gl_Position;

void main() {
  model_normal = normal;
  gl_Position = model_to_clip * vec4(position, 1.0);
  gl_Position.z += depth_shift * gl_Position.w;
  gl_ClipDistance[0] = dot(kept_side, vec4(position, 1.0));
}
