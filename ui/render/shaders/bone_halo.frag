// A ring around a line of teeth, on the bone before them or on what hides them; colours already times their alpha.
#include "seen_bone.glsl"

out vec4 colour;

uniform vec3 eye_mm;  // in the world
uniform mat4 ring_from_world;  // y along the teeth, z across them, x on to the bone
uniform vec3 ring_along, ring_across;  // those axes in the world
uniform vec4 ring;  // half of the straight sides, radius, how far to draw [mm]; a dash with its gap, 0: none
uniform float half_pixels, fill, halo_presence, is_behind;
uniform vec3 ink;

const float dash_share = 0.6;

void main() {
  look(eye_mm);
  vec3 at = (ring_from_world * vec4(in_world_mm, 1.0)).xyz;
  if (is_behind > 0.5) {
    // On the line of sight, beside the teeth.
    vec3 eye = (ring_from_world * vec4(eye_mm, 1.0)).xyz;
    at = eye + (at - eye) * (eye.x / (eye.x - at.x));
  }
  if (at.x < -1.0 || at.x > ring.z) discard;
  float beyond = max(abs(at.y) - ring.x, 0.0);
  float off = length(vec2(beyond, at.z));
  vec2 away = vec2(beyond * sign(at.y), at.z) / max(off, 1e-4);
  float pixel = is_behind > 0.5 ? length(eye_mm - in_world_mm) * length(pixel_up)
                                : change_over_pixel(away.x * ring_along + away.y * ring_across);
  float edge = 1.0 - smoothstep(half_pixels - 0.5, half_pixels + 0.5, abs(off - ring.y) / pixel);
  if (ring.w > 0.0) {
    float run = beyond > 0.0 ? atan(abs(at.z), beyond) * ring.y : abs(at.y);
    edge *= step(fract(run / ring.w), dash_share);
  }
  float inside = fill * (1.0 - smoothstep(0.55 * ring.y, ring.y, off));
  colour = vec4(ink, 1.0) * (halo_presence * max(edge * 0.95, inside));
}
