#version 330 core
// Multiplies the picture by the light at each pixel, from a picture of half the size.
uniform sampler2D depths;
uniform sampler2D light;   // and depth
uniform vec4 unproject;
uniform bool parallel;
out vec4 result;

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  float z = texelFetch(depths, at, 0).r;
  if (z >= 1.0) discard;
  z = z * 2.0 - 1.0;
  float depth = parallel ? (unproject.w - z) / unproject.z : unproject.w / (z + unproject.z);
  vec2 half_at = vec2(at) * 0.5;
  ivec2 low = ivec2(floor(half_at)), most = textureSize(light, 0) - 1;
  vec2 part = half_at - vec2(low);
  float sum = 0.0, weight = 1e-4;
  for (int i = 0; i < 4; ++i) {
    ivec2 step = ivec2(i & 1, i >> 1);
    vec2 there = texelFetch(light, min(low + step, most), 0).rg;
    vec2 share = mix(1.0 - part, part, vec2(step));
    float w = (share.x * share.y + 0.01) / (1.0 + 400.0 * abs(there.g - depth) / depth);
    sum += w * there.r;
    weight += w;
  }
  result = vec4(vec3(min(1.0, sum / weight)), 1.0);
}
