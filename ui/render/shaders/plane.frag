// Filled thinly, with a line of two pixels inside its edge.
in vec2 place_mm;
out vec4 colour;

uniform vec2 half_mm;
uniform vec3 ink;
uniform vec2 fill_and_line;  // opacities
uniform float pixel_scale;

void main() {
  vec2 inside = (half_mm - abs(place_mm)) / max(fwidth(place_mm), vec2(1e-5));
  float line = 1.0 - smoothstep(1.4, 2.4, min(inside.x, inside.y) / pixel_scale);
  colour = vec4(ink, mix(fill_and_line.x, fill_and_line.y, line));
}
