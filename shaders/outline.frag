#version 330 core
// A line around what the mask (in alpha) shows, outside of it.
uniform sampler2D mask;
uniform vec4 colour;
uniform float width;   // in pixels
uniform vec2 pixel;    // its size in the mask

out vec4 result;

float at(vec2 place) { return texture(mask, place).a; }

void main() {
  vec2 here = gl_FragCoord.xy * pixel;
  float inside = at(here);
  if (inside > 0.99) discard;
  float near = 0.0;
  for (int i = 0; i < 12; ++i) {
    float angle = 0.5235988 * float(i);
    vec2 way = vec2(cos(angle), sin(angle)) * pixel;
    near = max(near, at(here + way * width));
    if (i % 2 == 0) near = max(near, at(here + way * (0.5 * width)));
  }
  if (near < 0.01) discard;
  result = vec4(colour.rgb, colour.a * near * (1.0 - inside));
}
