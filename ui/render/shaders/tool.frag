// Steel mirrors a studio that goes with the viewer: a large soft box above, a strip at the side, a dark floor.
#include "light.glsl"

in vec3 in_tool_mm, in_world_mm, normal_in_world;
flat in float material;
flat in float is_face;
out vec4 colour;

uniform vec3 view_right, view_back;
uniform sampler3D noise;

vec3 studio(vec3 way, float blur) {
  float up = dot(way, view_up), right = dot(way, view_right), back = dot(way, view_back);
  float box = smoothstep(0.30 - blur, 0.55 + blur, up) * smoothstep(-0.75, -0.35, -right + 0.5 * back);
  float strip = smoothstep(0.30 + blur, 0.05, abs(right - 0.72)) * smoothstep(-0.6, 0.0, up + 0.3);
  float horizon = smoothstep(-0.5 - blur, 0.15 + blur, up);
  vec3 floor_light = mix(vec3(0.020, 0.023, 0.028), vec3(0.115, 0.12, 0.13), is_light_ground);
  vec3 sky = mix(vec3(0.13, 0.15, 0.175), vec3(0.36, 0.385, 0.41), is_light_ground);
  return mix(floor_light, sky, horizon) + vec3(0.95, 0.97, 1.0) * (1.05 * box) +
         vec3(0.50, 0.58, 0.68) * (0.55 * strip);
}

vec3 blade(vec3 normal, vec3 to_eye) {
  float scratch = texture(noise, in_tool_mm * vec3(0.05, 1.1, 0.5)).a - 0.5;
  vec3 brushed = normalize(normal + scratch * 0.07 * view_up);
  vec3 steel = vec3(0.56, 0.58, 0.61) * studio(reflect(-to_eye, brushed), 0.25) +
               vec3(0.13, 0.14, 0.15) * (0.55 + 0.45 * max(dot(brushed, key_light), 0.0));
  // Depth marks across the blade each 5 mm, and a rim where it was ground.
  float mark = abs(fract(in_tool_mm.x / 5.0 + 0.5) - 0.5) * 5.0;
  float width = max(fwidth(in_tool_mm.x), 0.02);
  float etched = (1.0 - smoothstep(0.09, 0.09 + width, mark)) * step(in_tool_mm.x, -2.0) *
                 step(abs(in_tool_mm.y), 3.4) * is_face;
  return steel * (1.0 - 0.62 * etched) * (1.0 + 0.18 * (1.0 - is_face));
}

void main() {
  vec3 to_eye = normalize(eye_mm - in_world_mm), normal = normalize(normal_in_world);
  vec3 mirrored = reflect(-to_eye, normal);
  vec3 light;
  if (material < 0.5) {
    light = blade(normal, to_eye);
  } else if (material < 1.5) {
    light = vec3(0.60, 0.615, 0.64) * studio(mirrored, 0.12) + vec3(0.035) * around(normal);
  } else if (material < 2.5) {
    float grain = texture(noise, in_tool_mm * 0.9).a;
    light = lit(vec3(0.030, 0.034, 0.040) * (0.85 + 0.3 * grain), normal, to_eye, 1.0, 1.0) +
            studio(mirrored, 0.45) * (0.030 + 0.26 * fresnel(normal, to_eye));
  } else {
    light = lit(vec3(0.21, 0.225, 0.245), normal, to_eye, 1.0, 1.0) +
            studio(mirrored, 0.3) * (0.05 + 0.3 * fresnel(normal, to_eye));
  }
  colour = vec4(shown(light), 1.0);
}
