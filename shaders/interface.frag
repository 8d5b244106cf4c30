#version 330 core
in vec2 at;
in vec4 colour;
uniform sampler2D glyphs;
out vec4 result;
void main() { result = colour * texture(glyphs, at); }
