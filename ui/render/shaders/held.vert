layout(location = 0) in vec2 in_kerf_mm;

uniform mat4 clip_from_kerf;

out vec2 place_mm;

void main() {
  place_mm = in_kerf_mm;
  gl_Position = clip_from_kerf * vec4(in_kerf_mm, 0.0, 1.0);
}
