// Steel mirrors a studio that goes with the viewer: a large soft box above, a strip at the side, a dark floor.
#include "light.glsl"

in vec3 in_tool_mm, in_world_mm, normal_in_world;
flat in float material;
flat in float is_face;
out vec4 colour;

uniform vec3 view_right, view_back;
uniform sampler3D noise;

#ifdef SEEN_THROUGH
#include "seen_through.glsl"

uniform float is_translucent_part;  // 1: draws what is seen through, 0: the rest
uniform float whole_from;           // presence from which it counts as the rest
#endif

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

#ifdef BLADE
vec3 blade(vec3 normal, vec3 to_eye) {
  // Brushed along the blade; never quite flat, so light runs over it in broad soft bands.
  float scratch = texture(noise, in_tool_mm * vec3(0.02, 0.9, 0.5)).a - 0.5;
  float broad = texture(noise, in_tool_mm * vec3(0.016, 0.022, 0.3) + 0.1).r - 0.5;
  vec3 brushed = normalize(normal + (0.10 * scratch + 0.9 * broad) * view_up + 0.5 * broad * view_right);
  float sheen = exp2(-9.0 * (1.0 - dot(brushed, normalize(key_light + to_eye))));
  vec3 steel = vec3(0.46, 0.48, 0.51) * studio(reflect(-to_eye, brushed), 0.5) +
               vec3(0.115, 0.122, 0.135) * (0.75 + 0.5 * broad + 0.35 * scratch) +
               vec3(0.50, 0.52, 0.54) * sheen;
  // Depth marks across the blade each 5 mm, and a rim where it was ground.
  float mark = abs(fract(in_tool_mm.x / 5.0 + 0.5) - 0.5) * 5.0;
  float width = max(fwidth(in_tool_mm.x), 0.02);
  float etched = (1.0 - smoothstep(0.09, 0.09 + width, mark)) * step(in_tool_mm.x, -2.0) *
                 step(abs(in_tool_mm.y), 3.4) * is_face;
  return steel * (1.0 - 0.62 * etched) * (1.0 + 0.18 * (1.0 - is_face));
}

#endif

void main() {
  float share = 1.0;
#ifdef SEEN_THROUGH
  share = presence_at(in_world_mm, eye_mm);
  if ((share < whole_from) != (is_translucent_part > 0.5)) discard;
#endif
  vec3 to_eye = normalize(eye_mm - in_world_mm), normal = normalize(normal_in_world);
#ifdef BLADE
  vec3 light = blade(normal, to_eye);
#else
  vec3 mirrored = reflect(-to_eye, normal);
  bool is_steel = material < 1.5, is_grip = !is_steel && material < 2.5;
  float grazing = fresnel(normal, to_eye);
  vec3 own = is_steel ? vec3(0.035) : is_grip ? vec3(0.030, 0.034, 0.040) : vec3(0.21, 0.225, 0.245);
  vec3 mirror = is_steel ? vec3(0.60, 0.615, 0.64) : vec3(0.035 + 0.27 * grazing);
  vec3 light = lit(own, normal, Reach(1.0, 1.0, 1.0)) + mirror * studio(mirrored, is_steel ? 0.12 : 0.42);
#endif
  colour = vec4(shown(light), share);
}
