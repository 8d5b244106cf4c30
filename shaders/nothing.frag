#version 330 core
// For passes that write depth or stencil only.
void main() {}
