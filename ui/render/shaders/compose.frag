// Two eyes' pictures into one: beside each other, or in red and cyan.
out vec4 colour;

uniform sampler2D left_eye, right_eye;
uniform vec4 picture;  // left, bottom, 1 / width, 1 / height in pixels
uniform int mode;      // 0 the left eye alone, 1 side by side, 2 anaglyph
uniform mat4 left_to_shown, right_to_shown;

vec3 linear(vec3 srgb) { return srgb * srgb; }

void main() {
  vec2 place = (gl_FragCoord.xy - picture.xy) * picture.zw;
  if (mode == 0) {
    colour = vec4(texture(left_eye, place).rgb, 1.0);
  } else if (mode == 1) {
    bool is_left = place.x < 0.5;
    vec2 half_place = vec2(place.x * 2.0 - (is_left ? 0.0 : 1.0), place.y);
    colour = vec4(is_left ? texture(left_eye, half_place).rgb : texture(right_eye, half_place).rgb, 1.0);
  } else {
    vec3 sum = mat3(left_to_shown) * linear(texture(left_eye, place).rgb) +
               mat3(right_to_shown) * linear(texture(right_eye, place).rgb);
    colour = vec4(sqrt(clamp(sum, 0.0, 1.0)), 1.0);
  }
}
