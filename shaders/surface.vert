#version 330 core
// Flat shaded triangles: the colours of both sides are computed once for each corner.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;

uniform mat4 model_to_clip;
uniform mat3 normal_to_world;
uniform vec4 kept_side;    // a plane in model coordinates; its negative side is cut away
uniform float depth_shift; // keeps coplanar surfaces apart, in a fixed order
uniform vec3 key_light;    // towards the light, in world coordinates
uniform vec3 colour;

flat out vec3 front_colour;
flat out vec3 back_colour;

invariant gl_Position;

vec3 lit(vec3 n) {
  float sky = 0.5 + 0.5 * n.z;
  float light = 0.30 + 0.24 * sky + 0.52 * max(dot(n, key_light), 0.0);
  // Light adds up in linear values, of which squares are a fair picture.
  return sqrt(colour * colour * light);
}

void main() {
  vec3 n = normalize(normal_to_world * normal);
  front_colour = lit(n);
  back_colour = lit(-n);
  gl_Position = model_to_clip * vec4(position, 1.0);
  gl_Position.z += depth_shift * gl_Position.w;
  gl_ClipDistance[0] = dot(kept_side, vec4(position, 1.0));
}
