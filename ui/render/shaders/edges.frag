// Edges without stairs: where two neighbours differ, their border is followed to both sides to where it ends and to which side it
// turns there. That tells the line for which the stairs stand, and a pixel takes as much of its neighbour's colour as lies
// beyond that line. What is the same on both sides of each border stays as it was, to the last bit.
// source  Reshetov 2009, Morphological antialiasing (shapes of Z, U and L); Jimenez, Masia, Echevarria, Navarro, Gutierrez 2011,
//         Practical morphological antialiasing, in GPU Pro 2 (on the graphics card, by borders)
out vec4 colour;

uniform sampler2D picture_colours;
uniform vec2 into_place;  // the target's left and bottom
#ifdef MOVING
uniform sampler2D still_colours;  // what lies below that moves
#endif

const int reach = 8;            // pixels to each side
const float least_step = 0.07;  // of the channel that tells two colours best apart

ivec2 last;

ivec2 inside(ivec2 place) { return clamp(place, ivec2(0), last); }
vec3 at(ivec2 place) { return texelFetch(picture_colours, inside(place), 0).rgb; }

bool differ(vec3 one, vec3 other) {
  vec3 step = abs(one - other);
  return max(step.r, max(step.g, step.b)) > least_step;
}

// To one side: where the border ends, in pixels from this pixel's middle, and half a pixel to the side to which it turns there,
// below zero towards this pixel; 0 where it turns to none or to both.
vec2 end_of_border(ivec2 here, ivec2 across, ivec2 along) {
  vec3 mine = at(here), theirs = at(here + across);
  for (int i = 1; i <= reach; ++i) {
    vec3 my_next = at(here + i * along), their_next = at(here + across + i * along);
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

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy - into_place);
  last = textureSize(picture_colours, 0) - 1;
  vec3 mine = at(here);
  ivec2 up = ivec2(0, 1), right = ivec2(1, 0);
  vec3 above = at(here + up), below = at(here - up), beside = at(here + right), before = at(here - right);
  bvec4 has_border = bvec4(differ(mine, above), differ(mine, below), differ(mine, beside), differ(mine, before));
#ifdef MOVING
  if (any(has_border)) {
    bool is_mine = mine != texelFetch(still_colours, here, 0).rgb;
    has_border.x = has_border.x && (is_mine || above != texelFetch(still_colours, inside(here + up), 0).rgb);
    has_border.y = has_border.y && (is_mine || below != texelFetch(still_colours, inside(here - up), 0).rgb);
    has_border.z = has_border.z && (is_mine || beside != texelFetch(still_colours, inside(here + right), 0).rgb);
    has_border.w = has_border.w && (is_mine || before != texelFetch(still_colours, inside(here - right), 0).rgb);
  }
#endif
  vec4 shares = vec4(0.0);
  if (has_border.x) shares.x = share_beyond(here, up, right);
  if (has_border.y) shares.y = share_beyond(here, -up, right);
  if (has_border.z) shares.z = share_beyond(here, right, up);
  if (has_border.w) shares.w = share_beyond(here, -right, up);
  // A pixel between borders on all sides is a speck, not a corner: half of it stays.
  float sum = dot(shares, vec4(1.0));
  shares *= 0.5 / max(sum, 0.5);
  colour = vec4(mine + shares.x * (above - mine) + shares.y * (below - mine) + shares.z * (beside - mine) +
                    shares.w * (before - mine),
                1.0);
}
