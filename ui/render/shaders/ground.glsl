// The ground behind everything: brightest at one place, darker towards the corners.
uniform vec3 ground_middle, ground_rim;  // sRGB
uniform vec2 ground_place;               // shares of the picture from the lower left
uniform vec4 picture;                    // left, bottom, 1 / width, 1 / height in pixels
uniform float picture_aspect;

vec3 ground_here() {
  vec2 away = (gl_FragCoord.xy - picture.xy) * picture.zw - ground_place;
  away.x *= picture_aspect;
  return mix(ground_middle, ground_rim, smoothstep(0.0, 0.95, length(away)));
}
