// A crumb: round-ish, lit from above.
#include "light.glsl"

in float wetness;
flat in float seed;
out vec4 colour;

void main() {
  vec2 at = gl_PointCoord * 2.0 - 1.0;
  at.x *= 1.0 + 0.5 * seed;
  float out_of = dot(at, at);
  if (out_of > 1.0) discard;
  vec3 bone = mix(vec3(0.80, 0.71, 0.56), vec3(0.50, 0.24, 0.16), wetness) * (0.85 + 0.3 * seed);
  colour = vec4(shown(bone * (0.75 - 0.45 * at.y)), 1.0);
}
