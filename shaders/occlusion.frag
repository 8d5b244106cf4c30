#version 330 core
// How much of the sky around a point its surroundings hide: samples on a spiral around the pixel,
// each counted by how far it rises above the surface there. Half the size of the picture.
uniform sampler2D depths;
uniform vec4 unproject;    // x and y of the view at depth one; a and b of depth = b / (z + a)
uniform bool parallel;     // without perspective depth = (b - z) / a
uniform float radius;      // in the world
uniform float pixels;      // of the radius at depth one, or anywhere if parallel
uniform float most_pixels;

out vec2 result;           // light, depth

float depth_of(float z) {
  return parallel ? (unproject.w - z) / unproject.z : unproject.w / (z + unproject.z);
}

vec3 place_at(ivec2 at, ivec2 size) {
  float z = texelFetch(depths, clamp(at, ivec2(0), size - 1), 0).r * 2.0 - 1.0;
  vec2 ndc = (vec2(at) + 0.5) / vec2(size) * 2.0 - 1.0;
  float depth = depth_of(z);
  return vec3(ndc * unproject.xy * (parallel ? 1.0 : depth), -depth);
}

// Of two neighbours the one at the smaller step in depth lies on the same face.
vec3 slope(vec3 here, vec3 before, vec3 after) {
  vec3 a = here - before, b = after - here;
  return abs(a.z) < abs(b.z) ? a : b;
}

void main() {
  ivec2 size = textureSize(depths, 0);
  ivec2 at = min(ivec2(gl_FragCoord.xy) * 2, size - 1);
  if (texelFetch(depths, at, 0).r >= 1.0) {
    result = vec2(1.0, 60000.0);
    return;
  }
  vec3 here = place_at(at, size);
  vec3 normal = cross(
      slope(here, place_at(at - ivec2(1, 0), size), place_at(at + ivec2(1, 0), size)),
      slope(here, place_at(at - ivec2(0, 1), size), place_at(at + ivec2(0, 1), size)));
  normal = normalize(normal);
  float depth = -here.z;
  float reach = min(pixels / (parallel ? 1.0 : depth), most_pixels);
  // Sixteen ways to turn the spiral, side by side; blurring brings them together.
  ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
  float turn = float((cell.x * 5 + cell.y * 7 + (cell.x ^ cell.y) * 3) & 15) * 0.3926991;
  const int samples = 14;
  float hidden = 0.0;
  for (int i = 0; i < samples; ++i) {
    float t = (float(i) + 0.5) / float(samples);
    float angle = turn + t * 31.4159265;
    vec3 v = place_at(at + ivec2(round(vec2(cos(angle), sin(angle)) * (t * reach))), size) - here;
    float square = dot(v, v);
    float rise = dot(v, normal) - 0.02 * radius;
    float near = max(0.0, 1.0 - square / (radius * radius));
    hidden += near * near * max(rise, 0.0) * inversesqrt(square + 1e-4 * radius * radius);
  }
  result = vec2(clamp(1.0 - 1.9 * hidden / float(samples), 0.0, 1.0), depth);
}
