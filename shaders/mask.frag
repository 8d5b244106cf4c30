#version 330 core
// Where something is: only alpha is written.
out vec4 result;
void main() { result = vec4(0.0, 0.0, 0.0, 1.0); }
