// The outer surface: warm ivory in large soft patches, fine relief along the shaft, small pores.
#include "light.glsl"
#include "ground.glsl"
#include "tool_shadow.glsl"
#include "seen_bone.glsl"

out vec4 colour;

uniform sampler3D noise, relief;
uniform float slope_scale;
uniform float presence;

// Fibres run along the shaft (x): noise is drawn out that way.
const vec3 fibre = vec3(0.085, 0.150, 0.150);

// The normal after the relief was laid on the surface.
vec3 raised(vec3 slope_share) {
  vec3 slope = mat3(world_from_bone) * ((slope_share - 0.5) * slope_scale * fibre);
  return normalize(plain_normal - slope + plain_normal * dot(plain_normal, slope));
}

void main() {
  look(eye_mm);
  vec4 patches = texture(noise, in_bone_mm * vec3(0.020, 0.027, 0.027));
  vec4 fine = texture(relief, in_bone_mm * fibre + 0.37);

  float warm = smoothstep(0.25, 0.75, patches.r), stain = smoothstep(0.50, 0.95, patches.b);
  vec3 albedo = mix(vec3(0.70, 0.585, 0.405), vec3(0.855, 0.775, 0.625), warm);
  albedo = mix(albedo, vec3(0.66, 0.50, 0.335), 0.35 * stain) * (1.10 * fine.a);
  // Seen from inside only where bone is cut away, at what still hangs together behind it.
  if (face < -50.0) albedo = vec3(0.22, 0.13, 0.085);

  vec3 normal = raised(fine.rgb);
  float open = openness * openness;
  Reach reach = Reach(open, mix(0.45, 1.0, open), 1.0);
#ifdef SHADOW
  reach.past_saw = key_share_at(in_tool_mm);
#endif
  vec3 light = lit(albedo, normal, reach);
  light += key_colour * key_after(reach.past_saw) *
           (0.085 * gloss(normal, to_eye, 26.0) * (0.4 + 0.6 * open) * fine.a);
  light += vec3(0.74, 0.73, 0.72) * (0.075 * fresnel(normal, to_eye) * open);
  vec3 here = shown(light);
#ifdef FADED
  here = mix(ground_here(), here, presence);
#endif
  colour = vec4(here, 1.0);
}
