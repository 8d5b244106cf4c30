#version 330 core
// Grid lines of two densities and two axes, all fading with the distance and where they
// would crowd.
in vec2 place;

uniform vec2 centre;
uniform vec2 target;     // where it is clearest, relative to centre
uniform float reach;
uniform float step_size;
uniform float fine;      // how visible the finer lines are, 0 … 1
uniform float line_width;
uniform bool show_grid;
uniform bool show_axes;
uniform vec4 grid_colour;
uniform vec3 first_colour;   // of the axes
uniform vec3 second_colour;
uniform float strength;

out vec4 result;

// Coverage of lines at multiples of `size`, for both directions.
float lines(float size, vec2 pixel, float width) {
  vec2 away = abs(fract(place / size + 0.5) - 0.5) * size / pixel;
  vec2 cover = clamp(0.5 * width + 0.5 - away, 0.0, 1.0) * min(width, 1.0);
  vec2 room = smoothstep(vec2(2.5), vec2(8.0), size / pixel);
  cover *= room;
  return max(cover.x, cover.y);
}

void main() {
  vec2 pixel = fwidth(place);
  float fade = 1.0 - smoothstep(0.25 * reach, 0.95 * reach, length(place - target));
  fade *= strength;
  if (fade <= 0.0) discard;
  float grid = 0.0;
  if (show_grid) {
    grid = max(lines(step_size, pixel, line_width) * 0.55 * fine,
               lines(step_size * 10.0, pixel, line_width));
  }
  vec4 colour = vec4(grid_colour.rgb, grid_colour.a * grid);
  if (show_axes) {
    vec2 away = abs(place + centre) / pixel;
    vec2 cover = clamp(0.8 * line_width + 0.5 - away, 0.0, 1.0);
    colour = mix(colour, vec4(first_colour, 0.9), cover.y);
    colour = mix(colour, vec4(second_colour, 0.9), cover.x);
  }
  result = vec4(colour.rgb, colour.a * fade);
}
