// Where planes meet the skin, the later over the earlier; colours already times their alpha.
#include "seen_bone.glsl"

out vec4 colour;

uniform vec3 eye_mm;  // in the world
uniform vec4 line_normal[LINES], line_along[LINES], line_across[LINES];  // unit direction in the world, offset
uniform vec4 line_style[LINES];  // colour, half width in pixels
uniform vec4 line_reach[LINES];  // half along, half across, faintly beyond [mm]; a dash with its gap [mm], 0: none
uniform vec4 line_more[LINES];   // presence, tick along the normal [mm]

const float dash_share = 0.64, faint_share = 0.18;

float off_plane(vec4 plane) { return dot(plane.xyz, in_world_mm) - plane.w; }

// Along the line as it runs over the surface here.
float dashed(int i, float along, float across) {
  vec3 run = cross(plain_normal, line_normal[i].xyz);
  bool is_along = abs(dot(run, line_along[i].xyz)) > abs(dot(run, line_across[i].xyz));
  return step(fract((is_along ? along : across) / line_reach[i].w), dash_share);
}

float line_share(int i) {
  float off = off_plane(line_normal[i]), along = off_plane(line_along[i]), across = off_plane(line_across[i]);
  float half_width = line_style[i].w;
  float pixels = abs(off) / change_over_pixel(line_normal[i].xyz);
  float share = 1.0 - smoothstep(half_width - 0.5, half_width + 0.5, pixels);
  if (line_reach[i].w > 0.0) share *= dashed(i, along, across);
  if (line_more[i].y > 0.0) {
    float beside = abs(across) / change_over_pixel(line_across[i].xyz);
    float tick = (1.0 - smoothstep(half_width - 0.5, half_width + 0.5, beside)) * step(0.0, off) * step(off, line_more[i].y);
    share = max(share, tick);
  }
  vec2 beyond = abs(vec2(along, across)) - line_reach[i].xy;
  float most = max(beyond.x, beyond.y);
  return share * (most <= 0.0 ? 1.0 : most <= line_reach[i].z ? faint_share : 0.0) * line_more[i].x;
}

void main() {
  look(eye_mm);
  vec4 over = vec4(0.0);
  for (int i = 0; i < LINES; ++i) over = mix(over, vec4(line_style[i].xyz, 1.0), line_share(i) * 0.95);
  colour = over;
}
