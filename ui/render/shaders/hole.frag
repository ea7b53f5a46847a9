// A hole as one sees into it, laid on the skin inside of its rim; around it a lighter rim. Colours already times their alpha.
#include "light.glsl"
#include "seen_bone.glsl"

out vec4 colour;

uniform mat4 hole_from_world, world_from_hole;  // z out of the bone
uniform vec4 rim_points[64];  // in the hole's frame
uniform int rim_count;
uniform float radius_mm, presence;
uniform vec2 skin_range_mm;  // along the hole: skin beyond is another one
uniform vec2 rim_size;       // width in millimetres, and in pixels at the least

// Distance from the rim, below 0 inside of it.
float beyond_rim(vec2 at) {
  vec2 last = rim_points[rim_count - 1].xy;
  float nearest = 1e6;
  bool is_inside = false;
  for (int i = 0; i < rim_count; ++i) {
    vec2 here = rim_points[i].xy, side = last - here, from = at - here;
    vec2 off = from - side * clamp(dot(from, side) / max(dot(side, side), 1e-8), 0.0, 1.0);
    nearest = min(nearest, dot(off, off));
    if ((here.y > at.y) != (last.y > at.y) && from.x < side.x * from.y / side.y) is_inside = !is_inside;
    last = here;
  }
  return is_inside ? -sqrt(nearest) : sqrt(nearest);
}

// What the line of sight meets below the skin: the wall of a cylinder, of which less and less is lit.
vec3 inside(vec3 at, vec3 way) {
  float across = max(dot(way.xy, way.xy), 1e-6), along = dot(at.xy, way.xy);
  float off = along * along + across * (radius_mm * radius_mm - dot(at.xy, at.xy));
  float to_wall = (sqrt(max(off, 0.0)) - along) / across;
  vec3 wall = at + clamp(to_wall, 0.0, 20.0 * radius_mm) * way;
  float depth = max(at.z - wall.z, 0.0) / radius_mm;
  vec3 normal = mat3(world_from_hole) * vec3(-normalize(wall.xy + 1e-6), 0.0);
  float open = exp2(-1.7 * depth);
  vec3 bone = mix(vec3(0.16, 0.07, 0.045), vec3(0.50, 0.36, 0.24), exp2(-2.5 * depth));
  return lit(bone, normal, Reach(0.55 * open, 0.60 * open, 1.0)) * (0.25 + 0.75 * open);
}

void main() {
  look(eye_mm);
  vec3 at = (hole_from_world * vec4(in_world_mm, 1.0)).xyz;
  if (at.z < skin_range_mm.x || at.z > skin_range_mm.y) discard;
  vec3 outward = world_from_hole[2].xyz;
  if (dot(plain_normal, outward) < 0.0) discard;
  float beyond = beyond_rim(at.xy);
  float right = length((hole_from_world * vec4(step_right_mm, 0.0)).xy);
  float up = length((hole_from_world * vec4(step_up_mm, 0.0)).xy);
  float pixel = max(0.5 * (right + up), 1e-5);
  float is_inside = clamp(0.5 - beyond / pixel, 0.0, 1.0);
  float width = max(rim_size.x, rim_size.y * pixel);
  float is_rim = clamp(0.5 + (width - beyond) / pixel, 0.0, 1.0) * (1.0 - is_inside);
  vec3 rim = shown(lit(vec3(0.93, 0.88, 0.78), plain_normal, Reach(1.0, 1.0, 1.0)));
  vec3 way = (hole_from_world * vec4(-to_eye, 0.0)).xyz;
  vec4 hole = vec4(shown(inside(at, way)), 1.0) * is_inside;
  colour = presence * (hole + vec4(rim, 1.0) * (0.50 * is_rim));
}
