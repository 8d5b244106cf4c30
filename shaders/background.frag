#version 330 core
in vec2 place;
uniform vec3 top;
uniform vec3 bottom;
out vec4 result;
void main() { result = vec4(mix(bottom, top, smoothstep(0.0, 1.0, place.y)), 0.0); }
