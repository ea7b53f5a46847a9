// Faint with a dashed outline; where the blade is near filled, with a whole outline and rings.
in vec3 in_world_mm, normal_in_world;
in float along_mm;
out vec4 colour;

uniform vec3 eye_mm, ink;
uniform float radius_mm, presence, is_near, dash_mm;
uniform vec2 pixel_and_half;  // width of a pixel one millimetre before the eye, half the outline in pixels

void main() {
  vec3 back = eye_mm - in_world_mm;
  float distance_mm = length(back);
  float facing = dot(normalize(normal_in_world), back / distance_mm);
  // So far from its rim a sphere of that radius is seen under this angle.
  float pixels = 0.5 * facing * facing * radius_mm / (distance_mm * pixel_and_half.x);
  float outline = 1.0 - smoothstep(2.0 * pixel_and_half.y - 0.5, 2.0 * pixel_and_half.y + 0.5, pixels);
  float dash = step(fract(along_mm / dash_mm), 0.6);
  float far = max(0.07, 0.62 * outline * dash);
  float rings = 0.20 * step(fract(along_mm / 2.0), 0.28);
  float near = max(0.22 + rings, 0.95 * outline);
  colour = vec4(ink, presence * mix(far, near, is_near));
}
