#version 330 core
// Lines one pixel wide, as the machine draws them: for many edges in motion.
layout(location = 0) in vec4 end;
uniform mat4 to_clip;
uniform vec4 kept_side;
uniform float depth_shift;

void main() {
  gl_Position = to_clip * vec4(end.xyz, 1.0);
  gl_Position.z += depth_shift * gl_Position.w;
  gl_ClipDistance[0] = dot(kept_side, vec4(end.xyz, 1.0));
}
