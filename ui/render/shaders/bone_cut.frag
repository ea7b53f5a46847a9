// What is seen inside: a rim of dense cortex, behind it reddish spongy bone, and the canal's wall. Which one follows from the
// depth below the bone as it was before any cut.
#include "light.glsl"
#include "ground.glsl"
#include "tool_shadow.glsl"
#include "seen_bone.glsl"

out vec4 colour;

uniform sampler3D noise, depth_volume;
uniform vec3 depth_scale, depth_shift;  // lattice coordinates from the bone frame
uniform vec4 cortex;                    // thickness in the middle, floor, length [mm]; 1 where there is a law
uniform float presence, pixel_scale;
uniform vec4 map_plane;  // normal in the bone frame, offset
uniform vec3 map_normal_in_world;
uniform vec4 map_faces;  // kerf (-1: all), side (0: both), range [mm], 1 where the map is on
uniform vec3 map_low, map_middle, map_high;  // sRGB

float cortex_mm() {
  if (cortex.w < 0.5) return 1000.0;
  float off = (in_bone_mm.x / cortex.z - 0.5) / 0.22;
  return max(cortex.x * (0.35 + 0.65 * exp2(-1.4427 * off * off)), cortex.y);
}

vec3 spongy(out float hollow) {
  vec4 coarse = texture(noise, in_bone_mm * 0.105), small = texture(noise, in_bone_mm * 0.24 + 0.2);
  hollow = max(1.0 - smoothstep(0.42, 0.74, coarse.g), 0.75 * (1.0 - smoothstep(0.36, 0.66, small.g)));
  vec3 strut = mix(vec3(0.70, 0.50, 0.35), vec3(0.80, 0.63, 0.47), small.r);
  vec3 marrow = mix(vec3(0.30, 0.085, 0.055), vec3(0.40, 0.16, 0.085), coarse.r);
  return mix(strut, marrow, hollow);
}

const float canal = -8.0;  // face = 4 kerf + side

bool is_mapped() {
  float kerf = floor((face + 1.5) / 4.0), side = face - 4.0 * kerf;
  return map_faces.w > 0.5 && kerf >= 0.0 && (map_faces.x < 0.0 || map_faces.x == kerf) &&
         (map_faces.y == 0.0 ? abs(side) > 0.5 : map_faces.y == side);
}

// Signed distance to the plan, unlit, with a dark line at each whole millimetre and a stronger one at none.
vec3 mapped(float cortical) {
  float off = dot(map_plane.xyz, in_bone_mm) - map_plane.w;
  float share = clamp(off / map_faces.z, -1.0, 1.0);
  vec3 base = share < 0.0 ? mix(map_middle, map_low, -share) : mix(map_middle, map_high, share);
  base *= mix(1.0, 0.955, cortical);
  float pixels = abs(fract(off + 0.5) - 0.5) / (pixel_scale * change_over_pixel(map_normal_in_world));
  float half_width = abs(off) < 0.5 ? 1.2 : 0.7;
  return base * (1.0 - 0.45 * (1.0 - smoothstep(half_width, half_width + 1.0, pixels)));
}

void main() {
  look(eye_mm);
  float depth = 32.0 * texture(depth_volume, in_bone_mm * depth_scale + depth_shift).r - 16.0;
  vec4 rough = texture(noise, in_bone_mm * 0.16);
  float edge = depth - cortex_mm() + 0.9 * (rough.r - 0.5);
  float inside = smoothstep(-0.22, 0.22, edge);

  float hollow;
  vec3 soft = spongy(hollow);
  vec3 dense = vec3(0.80, 0.70, 0.53) * (0.86 + 0.24 * rough.a) * (0.94 + 0.10 * rough.b);
  vec3 albedo = mix(dense, soft, inside);
  if (face < canal + 1.5) albedo = mix(vec3(0.42, 0.19, 0.10), vec3(0.56, 0.34, 0.19), rough.r);

  vec3 normal = plain_normal;
  // A slot is dark because its other wall is near; how dark follows from how deep one looks into it.
  float open = mix(exp2(-1.6 * max(depth, 0.0)), 1.0, openness);
  if (face < canal + 1.5) open = 0.30;
  open *= 1.0 - 0.55 * hollow * inside;
  Reach reach = Reach(open, mix(open, 1.0, openness) * mix(0.45, 1.0, open), key_share_at(in_tool_mm));
  vec3 light = lit(albedo, normal, reach);
  light += key_colour * key_after(reach.past_saw) *
           ((0.06 + 0.10 * hollow * inside) * gloss(normal, to_eye, 34.0) * open * reach.past_bone);
  vec3 here = shown(light);
  if (is_mapped()) here = mapped(1.0 - inside);
  colour = vec4(mix(ground_here(), here, presence), 1.0);
}
