// A disc with a rim against the ground.
out vec4 colour;

uniform vec3 ink, rim;
uniform float size_pixels;

void main() {
  float out_of = length(gl_PointCoord * 2.0 - 1.0) * 0.5 * size_pixels, edge = 0.5 * size_pixels;
  float share = smoothstep(edge - 2.6, edge - 1.8, out_of);
  colour = vec4(mix(ink, rim, share), 1.0 - smoothstep(edge - 1.0, edge, out_of));
}
