#version 330 core
// Line segments as quads with round ends: six vertices for each segment, pulled from a buffer.
uniform samplerBuffer ends;
uniform mat4 to_clip;
uniform vec4 kept_side;
uniform vec2 half_size;    // of the viewport, in pixels
uniform float half_width;  // of the line, in pixels
uniform float depth_shift;

noperspective out vec2 place;  // along and across the segment, in pixels
flat out float segment_length;

void main() {
  int segment = gl_VertexID / 6, corner = gl_VertexID % 6;
  bool at_end = corner == 1 || corner == 2 || corner == 4;
  float side = corner == 0 || corner == 1 || corner == 3 ? -1.0 : 1.0;
  vec4 a_world = vec4(texelFetch(ends, 2 * segment).xyz, 1.0);
  vec4 b_world = vec4(texelFetch(ends, 2 * segment + 1).xyz, 1.0);
  vec4 a = to_clip * a_world, b = to_clip * b_world;

  // What lies before the near plane has no place in the picture: cut it off first.
  float a_near = a.z + a.w, b_near = b.z + b.w;
  if (a_near < 0.0 && b_near > 0.0) a = mix(a, b, a_near / (a_near - b_near));
  if (b_near < 0.0 && a_near > 0.0) b = mix(b, a, b_near / (b_near - a_near));

  vec2 from = a.xy / a.w * half_size, to = b.xy / b.w * half_size;
  vec2 along = to - from;
  segment_length = length(along);
  along = segment_length > 1e-4 ? along / segment_length : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  float reach = half_width + 1.0;

  vec4 end = at_end ? b : a;
  vec2 pixel = (at_end ? to + along * reach : from - along * reach) + across * (side * reach);
  place = vec2(at_end ? segment_length + reach : -reach, side * reach);
  gl_Position = vec4(pixel / half_size * end.w, end.z + depth_shift * end.w, end.w);
  if (a_near < 0.0 && b_near < 0.0) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
  gl_ClipDistance[0] = dot(kept_side, at_end ? b_world : a_world);
}
