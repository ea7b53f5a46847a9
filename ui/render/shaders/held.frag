// Tinted, with stripes across.
in vec2 place_mm;
out vec4 colour;

uniform vec3 ink;
uniform float stripe_mm;

void main() {
  float stripe = abs(fract((place_mm.x + place_mm.y) / stripe_mm) - 0.5) * 2.0;
  float soft = 2.0 * fwidth(place_mm.x + place_mm.y) / stripe_mm;
  float share = 1.0 - smoothstep(0.42 - soft, 0.42 + soft, stripe);
  colour = vec4(ink, mix(0.26, 0.68, share));
}
