// Where a pixel differs from its neighbours. Green alone tells it: it is most of what is seen as bright, and on a processor the
// rest would cost as much again.
uniform sampler2D picture_colours;
uniform vec2 into_place;  // the target's left and bottom

const float least_step = 0.06;

float green(ivec2 place) { return texelFetch(picture_colours, place, 0).g; }
bool differ(float one, float other) { return abs(one - other) > least_step; }

// To above, below, right, left.
bvec4 borders_of(ivec2 here) {
  float mine = green(here);
  return bvec4(differ(mine, green(here + ivec2(0, 1))), differ(mine, green(here - ivec2(0, 1))),
               differ(mine, green(here + ivec2(1, 0))), differ(mine, green(here - ivec2(1, 0))));
}
