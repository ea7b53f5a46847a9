// Edges without stairs: where two neighbours differ, their border is followed to both sides to where it ends and to which side it
// turns there. That tells the line for which the stairs stand, and a pixel takes as much of its neighbour's colour as lies
// beyond that line.
// source  Reshetov 2009, Morphological antialiasing (shapes of Z, U and L); Jimenez, Masia, Echevarria, Navarro, Gutierrez 2011,
//         Practical morphological antialiasing, in GPU Pro 2 (by borders, those found first marked in the stencil); green as
//         brightness: Lottes 2009, FXAA
#include "borders.glsl"
out vec4 colour;

const int reach = 8;  // pixels to each side

ivec2 last;

float green_inside(ivec2 place) { return green(clamp(place, ivec2(0), last)); }

// To one side: where the border ends, in pixels from this pixel's middle, and half a pixel to the side to which it turns there,
// below zero towards this pixel; 0 where it turns to none or to both.
vec2 end_of_border(ivec2 here, ivec2 across, ivec2 along) {
  float mine = green(here), theirs = green(here + across);
  for (int i = 1; i <= reach; ++i) {
    float my_next = green_inside(here + i * along), their_next = green_inside(here + across + i * along);
    bool turns_to_me = differ(mine, my_next), turns_away = differ(theirs, their_next);
    if (turns_to_me || turns_away || !differ(my_next, their_next)) {
      return vec2(float(i) - 0.5, turns_to_me == turns_away ? 0.0 : turns_to_me ? -0.5 : 0.5);
    }
    mine = my_next;
    theirs = their_next;
  }
  return vec2(float(reach) + 0.5, 0.0);
}

// From each end the line comes back to the border halfway to the other; with ends on two sides that is one straight line.
float depth_of_line(float x, float length, vec2 ends) {
  float height = x < 0.5 * length ? ends.x * (1.0 - 2.0 * x / length) : ends.y * (2.0 * x / length - 1.0);
  return max(-height, 0.0);
}

float share_beyond(ivec2 here, ivec2 across, ivec2 along) {
  vec2 back = end_of_border(here, across, -along), ahead = end_of_border(here, across, along);
  vec2 ends = vec2(back.y, ahead.y);
  if (min(ends.x, ends.y) >= 0.0) return 0.0;
  float length = back.x + ahead.x;
  return 0.5 * (depth_of_line(back.x - 0.25, length, ends) + depth_of_line(back.x + 0.25, length, ends));
}

vec3 shown(ivec2 place) { return texelFetch(picture_colours, clamp(place, ivec2(0), last), 0).rgb; }

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy - into_place), up = ivec2(0, 1), right = ivec2(1, 0);
  last = textureSize(picture_colours, 0) - 1;
  bvec4 has_border = borders_of(here);
  vec4 shares = vec4(has_border.x ? share_beyond(here, up, right) : 0.0, has_border.y ? share_beyond(here, -up, right) : 0.0,
                     has_border.z ? share_beyond(here, right, up) : 0.0, has_border.w ? share_beyond(here, -right, up) : 0.0);
  // A pixel between borders on all sides is a speck, not a corner: half of it stays.
  float sum = dot(shares, vec4(1.0));
  shares *= 0.5 / max(sum, 0.5);
  vec3 kept = shown(here);
  colour = vec4(kept + shares.x * (shown(here + up) - kept) + shares.y * (shown(here - up) - kept) +
                    shares.z * (shown(here + right) - kept) + shares.w * (shown(here - right) - kept),
                1.0);
}
