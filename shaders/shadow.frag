#version 330 core
in vec2 place;
uniform sampler2D shadow;
uniform float strength;
out vec4 result;
void main() { result = vec4(0.0, 0.0, 0.0, strength * texture(shadow, place).r); }
