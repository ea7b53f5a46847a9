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
  // Brushed along the blade: what it mirrors is drawn out across it, and the flat plate bends the light a little.
  float scratch = texture(noise, in_tool_mm * vec3(0.02, 0.9, 0.5)).a - 0.5;
  float broad = texture(noise, in_tool_mm * vec3(0.012, 0.03, 0.3)).r - 0.5;
  vec3 brushed = normalize(normal + (0.06 * scratch + 0.30 * broad) * view_up + 0.10 * broad * view_right);
  float along = dot(brushed, normalize(key_light + to_eye));
  float sheen = exp2(-14.0 * (1.0 - along));
  vec3 steel = vec3(0.52, 0.54, 0.57) * studio(reflect(-to_eye, brushed), 0.35) +
               vec3(0.15, 0.16, 0.175) * (0.6 + 0.4 * max(dot(brushed, key_light), 0.0)) +
               vec3(0.62, 0.64, 0.66) * sheen;
  // Depth marks across the blade each 5 mm, and a rim where it was ground.
  float mark = abs(fract(in_tool_mm.x / 5.0 + 0.5) - 0.5) * 5.0;
  float width = max(fwidth(in_tool_mm.x), 0.02);
  float etched = (1.0 - smoothstep(0.09, 0.09 + width, mark)) * step(in_tool_mm.x, -2.0) *
                 step(abs(in_tool_mm.y), 3.4) * is_face;
  steel *= 1.0 - 0.10 * smoothstep(0.10, 0.9, abs(scratch) * 2.0);
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
