// Where planes meet the skin, the later over the earlier; colours already times their alpha.
#include "seen_bone.glsl"

out vec4 colour;

uniform vec3 eye_mm;  // in the world
uniform float presence;
uniform vec4 line_plane[LINES];   // unit normal in the world, offset
uniform vec4 line_window[LINES];  // unit direction in the plane, offset: the line ends `half` to both sides
uniform vec4 line_style[LINES];   // colour, half width in pixels
uniform vec4 line_half[LINES];    // x: half [mm], 0: no end

void main() {
  look(eye_mm);
  vec4 over = vec4(0.0);
  for (int i = 0; i < LINES; ++i) {
    float off = dot(line_plane[i].xyz, in_world_mm) - line_plane[i].w;
    float pixels = abs(off) / change_over_pixel(line_plane[i].xyz);
    float share = 1.0 - smoothstep(line_style[i].w - 0.5, line_style[i].w + 0.5, pixels);
    float end = abs(dot(line_window[i].xyz, in_world_mm) - line_window[i].w);
    if (line_half[i].x > 0.0) share *= 1.0 - 0.82 * step(line_half[i].x, end);
    over = mix(over, vec4(line_style[i].xyz, 1.0), share * 0.95);
  }
  colour = over * presence;
}
