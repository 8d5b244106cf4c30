#version 330 core
noperspective in vec2 place;
flat in float segment_length;

uniform vec4 colour;
uniform float half_width;

out vec4 result;

void main() {
  float beyond = max(max(-place.x, place.x - segment_length), 0.0);
  float coverage = clamp(half_width + 0.5 - length(vec2(beyond, place.y)), 0.0, 1.0);
  if (coverage <= 0.0) discard;
  result = vec4(colour.rgb, colour.a * coverage * min(1.0, 2.0 * half_width));
}
