// A rectangle from the vertex's number; `place` runs over it from -half to half.
uniform mat4 clip_from_plane;
uniform vec2 half_mm;

out vec2 place_mm;

void main() {
  place_mm = (vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0) * half_mm;
  gl_Position = clip_from_plane * vec4(place_mm, 0.0, 1.0);
}
