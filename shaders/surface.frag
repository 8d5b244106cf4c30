#version 330 core
// The colour of a surface, opaque or not.
flat in vec3 front_colour;
flat in vec3 back_colour;

uniform float alpha;
uniform bool cut_open;     // insides are seen through a section: they are hatched
uniform float hatch_width; // in pixels

out vec4 result;

void main() {
  vec3 c = gl_FrontFacing ? front_colour : back_colour;
  if (cut_open && !gl_FrontFacing) {
    float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / hatch_width) - 0.5) * hatch_width;
    c = mix(front_colour, back_colour, 0.5) * mix(0.62, 0.88, smoothstep(0.6, 1.6, stripe));
  }
  result = vec4(c, alpha);
}
