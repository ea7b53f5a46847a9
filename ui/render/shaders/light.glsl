// Three lights that go with the viewer, and light from all around. Colours of surfaces are linear (squares of what is
// shown); shown() goes back.
uniform vec3 eye_mm;  // in the world
uniform vec3 key_light, fill_light, rim_light, view_up;  // unit directions towards the light
uniform float is_light_ground;  // 0 or 1

const vec3 key_colour = vec3(1.0, 0.95, 0.87);
const vec3 fill_colour = vec3(0.64, 0.63, 0.62);
const vec3 rim_colour = vec3(0.66, 0.78, 0.92);

vec3 linear(vec3 srgb) { return srgb * srgb; }

// The upper end bends, so that bright bone keeps its colour.
vec3 shown(vec3 light) {
  light = max(light, vec3(0.0));
  return sqrt(light * (1.0 + 0.10 * light) / (1.0 + 0.42 * light));
}

vec3 around(vec3 normal) {
  float up = 0.5 + 0.5 * dot(normal, view_up);
  vec3 dark = mix(vec3(0.060, 0.048, 0.038), vec3(0.200, 0.195, 0.190), up);
  vec3 light = mix(vec3(0.175, 0.165, 0.16), vec3(0.34, 0.355, 0.38), up);
  return mix(dark, light, is_light_ground);
}

// What of the key light is left in a full shadow: light that went around through bone and came out warmer.
const vec3 shadow_share = vec3(0.50, 0.425, 0.33);
// What a hollow sees instead of its surroundings: bone that is lit by bone.
const vec3 hollow_light = vec3(0.120, 0.072, 0.040);

// What of the key light comes to a place of which the saw leaves free so much.
vec3 key_after(float key_share) { return mix(shadow_share, vec3(1.0), key_share); }

// How much of it comes to a place: light of the surroundings, and key light past the bone itself and past the saw.
struct Reach {
  float around, past_bone, past_saw;
};

vec3 lit(vec3 albedo, vec3 normal, Reach reach) {
  float key = dot(normal, key_light);
  // Light that enters bone comes out a little further: the terminator is soft and warm.
  vec3 wrap = vec3(0.22, 0.14, 0.10);
  vec3 direct = clamp((key + wrap) / (1.0 + wrap), 0.0, 1.0);
  float fill = max(dot(normal, fill_light), 0.0), rim = max(dot(normal, rim_light), 0.0);
  float strength = mix(1.24, 1.02, is_light_ground) * reach.past_bone;
  vec3 light = mix(hollow_light * (0.4 + 0.6 * reach.around), around(normal), reach.around) +
               key_colour * direct * direct * key_after(reach.past_saw) * strength +
               (fill_colour * (fill * 0.20) + rim_colour * (rim * 0.10)) * reach.around;
  return albedo * light;
}

// A highlight of the key light, as wide as 1 / sharpness.
float gloss(vec3 normal, vec3 to_eye, float sharpness) {
  float along = dot(normal, normalize(key_light + to_eye));
  return exp2(sharpness * (along - 1.0) * 1.4427) * step(0.0, dot(normal, key_light));
}

float fresnel(vec3 normal, vec3 to_eye) {
  float off = 1.0 - max(dot(normal, to_eye), 0.0);
  return off * off * off * off;
}
