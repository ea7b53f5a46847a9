// Marks the pixels that have a border: only those are worth the search in edges.frag.
#include "borders.glsl"
out vec4 colour;

#ifdef MOVING
uniform sampler2D still_colours;  // what lies below that moves

bool moves(ivec2 place) { return green(place) != texelFetch(still_colours, place, 0).g; }
#endif

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy - into_place);
  bvec4 counts = borders_of(here);
#ifdef MOVING
  bvec4 moving = bvec4(moves(here + ivec2(0, 1)), moves(here - ivec2(0, 1)), moves(here + ivec2(1, 0)),
                       moves(here - ivec2(1, 0)));
  if (!moves(here)) counts = bvec4(counts.x && moving.x, counts.y && moving.y, counts.z && moving.z, counts.w && moving.w);
#endif
  if (!any(counts)) discard;
  colour = vec4(1.0);
}
