#version 330 core
noperspective in vec2 from_centre;

uniform vec4 colour;
uniform vec4 rim_colour;
uniform float radius;
uniform float rim_width;

out vec4 result;

void main() {
  float distance = length(from_centre);
  float coverage = clamp(radius + 0.5 - distance, 0.0, 1.0);
  if (coverage <= 0.0) discard;
  float inside = clamp(radius - rim_width + 0.5 - distance, 0.0, 1.0);
  result = vec4(mix(rim_colour.rgb, colour.rgb, inside), colour.a * coverage);
}
