layout(location = 0) in vec3 place_mm;

uniform mat4 clip_from_world;
uniform float size_pixels;

void main() {
  gl_Position = clip_from_world * vec4(place_mm, 1.0);
  gl_PointSize = size_pixels;
}
