// Dithered by half a step of 8 bits: without it the gradient shows bands.
#include "ground.glsl"
out vec4 colour;

void main() {
  float noise = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
  colour = vec4(ground_here() + (noise - 0.5) / 255.0, 1.0);
}
