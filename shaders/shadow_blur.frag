#version 330 core
// How much of the sky the things above hide from a place of the ground. `heights` is what is seen
// from below: 0 on the ground, 1 where nothing is near.
in vec2 place;
uniform sampler2D heights;
uniform float reach;       // of the softest shadow, as a share of the picture
out vec4 result;

void main() {
  const int samples = 48;
  float hidden = 0.0, whole = 0.0;
  for (int i = 0; i < samples; ++i) {
    float t = (float(i) + 0.5) / float(samples);
    float angle = t * 94.2477796;
    float weight = 1.0 - t * t;
    float height = texture(heights, place + vec2(cos(angle), sin(angle)) * (t * reach)).r;
    float open = 1.0 - height;
    hidden += weight * open * open;
    whole += weight;
  }
  vec2 rim = smoothstep(vec2(0.0), vec2(0.12), min(place, 1.0 - place));
  result = vec4(hidden / whole * rim.x * rim.y);
}
