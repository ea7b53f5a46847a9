// Dithered by half a step of 8 bits: without it the gradient shows bands.
#include "ground.glsl"
out vec4 colour;

void main() {
  float noise = fract(sin(dot(gl_FragCoord.xy, vec2(12.9898, 78.233))) * 43758.5453);
  colour = vec4(ground_here() + (noise - 0.5) / 255.0, 1.0);
}
