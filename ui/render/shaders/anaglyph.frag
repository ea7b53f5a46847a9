// Two eyes' pictures into one, in red and cyan, with the panels over both.
out vec4 colour;

uniform sampler2D left_eye, right_eye;
uniform sampler2D panels;  // as large as the picture; colours already times their alpha
uniform vec4 picture;  // left, bottom, 1 / width, 1 / height in pixels
// const mat3 left_to_shown, right_to_shown: said by who compiles this

vec3 linear(vec3 srgb) { return srgb * srgb; }

void main() {
  vec2 place = (gl_FragCoord.xy - picture.xy) * picture.zw;
  vec4 over = texelFetch(panels, ivec2(gl_FragCoord.xy - picture.xy), 0);
  vec3 left = over.rgb + (1.0 - over.a) * texture(left_eye, place).rgb;
  vec3 right = over.rgb + (1.0 - over.a) * texture(right_eye, place).rgb;
  vec3 sum = left_to_shown * linear(left) + right_to_shown * linear(right);
  colour = vec4(sqrt(clamp(sum, 0.0, 1.0)), 1.0);
}
