// The outer surface: warm ivory in large soft patches, fine relief along the shaft, small pores.
#include "light.glsl"
#include "ground.glsl"
#include "tool_shadow.glsl"

in vec3 in_bone_mm, in_world_mm, in_tool_mm, normal_in_world;
in float openness;
flat in vec2 face;
out vec4 colour;

uniform sampler3D noise;
uniform float presence;
uniform int line_count;
uniform vec4 line_plane[6];   // unit normal in the world, offset
uniform vec4 line_window[6];  // unit direction in the plane, offset: the line ends `half` to both sides
uniform vec4 line_style[6];   // colour, half width in pixels
uniform vec4 line_half[6];    // x: half [mm], 0: no end

vec3 with_lines(vec3 under) {
  for (int i = 0; i < line_count; ++i) {
    float off = dot(line_plane[i].xyz, in_world_mm) - line_plane[i].w;
    float pixels = abs(off) / max(fwidth(off), 1e-5);
    float share = 1.0 - smoothstep(line_style[i].w - 0.5, line_style[i].w + 0.5, pixels);
    float end = abs(dot(line_window[i].xyz, in_world_mm) - line_window[i].w);
    if (line_half[i].x > 0.0) share *= 1.0 - 0.82 * step(line_half[i].x, end);
    under = mix(under, line_style[i].xyz, share * 0.95);
  }
  return under;
}

// The surface's normal after the height `height` was laid on it (Mikkelsen 2010, from the picture's derivatives).
vec3 raised(vec3 normal, float height) {
  vec3 right = dFdx(in_world_mm), up = dFdy(in_world_mm);
  vec3 across = cross(up, normal), along = cross(normal, right);
  float area = dot(right, across);
  vec3 slope = sign(area) * (dFdx(height) * across + dFdy(height) * along);
  return normalize(abs(area) * normal - slope);
}

void main() {
  // Fibres run along the shaft (x): everything is drawn out that way.
  vec4 patches = texture(noise, in_bone_mm * vec3(0.020, 0.027, 0.027));
  vec4 fine = texture(noise, in_bone_mm * vec3(0.085, 0.150, 0.150) + 0.37);

  float warm = smoothstep(0.25, 0.75, patches.r), stain = smoothstep(0.50, 0.95, patches.b);
  vec3 albedo = mix(vec3(0.70, 0.585, 0.405), vec3(0.855, 0.775, 0.625), warm);
  albedo = mix(albedo, vec3(0.66, 0.50, 0.335), 0.35 * stain);
  albedo *= 0.90 + 0.20 * fine.r;
  // Pores are rare: where the clouds are thick.
  float pore = (1.0 - smoothstep(0.06, 0.24, fine.g)) * smoothstep(0.34, 0.66, fine.b);
  albedo *= 1.0 - 0.34 * pore;

  // Seen from inside only where bone is cut away, at what still hangs together behind it.
  if (!gl_FrontFacing) albedo = vec3(0.22, 0.13, 0.085);
  vec3 to_eye = normalize(eye_mm - in_world_mm);
  vec3 normal = raised(normalize(normal_in_world), 0.075 * fine.r + 0.05 * fine.b - 0.022 * pore);
  float open = openness * openness;
  float key_share = key_share_at(in_tool_mm);
  vec3 light = lit(albedo, normal, to_eye, open, key_share);
  light += key_colour * (0.085 * gloss(normal, to_eye, 26.0) * (0.4 + 0.6 * open) * key_share *
                         (1.0 - 0.7 * pore));
  light += vec3(0.60, 0.70, 0.82) * (0.075 * fresnel(normal, to_eye) * open);
  colour = vec4(mix(ground_here(), with_lines(shown(light)), presence), 1.0);
}
