// A disc, a ring, a diamond or a triangle, with a rim against the ground.
out vec4 colour;

uniform vec3 ink, rim;
uniform float size_pixels;
uniform int shape;

// Distance from the middle in shares of the way to the edge.
float outward(vec2 at) {
  if (shape == 2) return abs(at.x) + abs(at.y);
  if (shape == 3) return max(2.0 * at.y, abs(1.732 * at.x) - at.y);
  return length(at);
}

void main() {
  float edge = 0.5 * size_pixels, out_of = outward(gl_PointCoord * 2.0 - 1.0) * edge;
  float share = smoothstep(edge - 2.6, edge - 1.8, out_of);
  float seen = 1.0 - smoothstep(edge - 1.0, edge, out_of);
  if (shape == 1) seen *= smoothstep(0.52 * edge - 0.5, 0.52 * edge + 0.5, out_of);
  colour = vec4(mix(ink, rim, share), seen);
}
