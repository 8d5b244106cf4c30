#version 330 core
// Round marks as squares: six vertices for each place, pulled from a buffer.
uniform samplerBuffer places;
uniform mat4 to_clip;
uniform vec4 kept_side;
uniform vec2 half_size;
uniform float radius;
uniform float depth_shift;

noperspective out vec2 from_centre;  // in pixels

void main() {
  int corner = gl_VertexID % 6;
  vec2 side = vec2(corner == 1 || corner == 2 || corner == 4 ? 1.0 : -1.0,
                   corner == 2 || corner == 4 || corner == 5 ? 1.0 : -1.0);
  vec4 world = vec4(texelFetch(places, gl_VertexID / 6).xyz, 1.0);
  vec4 centre = to_clip * world;
  from_centre = side * (radius + 1.0);
  gl_Position = vec4(centre.xy + from_centre / half_size * centre.w,
                     centre.z + depth_shift * centre.w, centre.w);
  gl_ClipDistance[0] = dot(kept_side, world);
}
