layout(location = 0) in vec3 place_mm;
layout(location = 1) in vec2 size_and_wetness;

uniform mat4 clip_from_world;
uniform float pixels_at_one;  // pixels of one millimetre at clip w = 1

out float wetness;
flat out float seed;

void main() {
  gl_Position = clip_from_world * vec4(place_mm, 1.0);
  gl_PointSize = clamp(size_and_wetness.x * pixels_at_one / gl_Position.w, 1.0, 24.0);
  wetness = size_and_wetness.y;
  seed = fract(float(gl_VertexID) * 0.618);
}
