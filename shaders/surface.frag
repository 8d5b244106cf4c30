#version 330 core
// The colour of a surface, opaque or not.
in vec3 model_normal;

uniform mat3 normal_to_world;
uniform vec3 key_light;    // towards the light, in world coordinates
uniform vec3 colour;
uniform float alpha;
uniform bool cut_open;     // insides are seen through a section: they are hatched
uniform float hatch_width; // in pixels

out vec4 result;

vec3 lit(vec3 n) {
  // The tops of things are bright, their sides are not: what faces where is seen at a glance.
  float sky = 0.5 + 0.5 * n.z;
  float light = 0.25 + 0.36 * sky * sky + 0.46 * max(dot(n, key_light), 0.0);
  // Light adds up in linear values, of which squares are a fair picture.
  return colour * sqrt(light);
}

void main() {
  vec3 n = normalize(normal_to_world * model_normal);
  vec3 c = lit(gl_FrontFacing ? n : -n);
  if (cut_open && !gl_FrontFacing) {
    float stripe = abs(fract((gl_FragCoord.x + gl_FragCoord.y) / hatch_width) - 0.5) * hatch_width;
    c = colour * mix(0.62, 0.88, smoothstep(0.6, 1.6, stripe));
  }
  result = vec4(c, alpha);
}
