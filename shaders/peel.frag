#version 330 core
// Depth peeling from the back: keeps what lies in front of the layer before. The depth test keeps
// the farthest of it.
#ifdef MULTISAMPLE
#extension GL_ARB_sample_shading : require
uniform sampler2DMS layer_before;
float depth_before() {
  return texelFetch(layer_before, ivec2(gl_FragCoord.xy), gl_SampleID).r;
}
#else
uniform sampler2D layer_before;
float depth_before() { return texelFetch(layer_before, ivec2(gl_FragCoord.xy), 0).r; }
#endif

uniform float gap;  // what is closer together than this is one layer

void main() {
  if (gl_FragCoord.z >= depth_before() - gap) discard;
}
