// What bone.frag left at this pixel.
uniform sampler2D place_picture, normal_picture;
uniform mat4 world_from_bone, tool_from_bone;
uniform vec3 pixel_right, pixel_up;  // a pixel's width in the world, one millimetre in front of the eye

vec3 in_bone_mm, in_world_mm, in_tool_mm, plain_normal, to_eye;
float openness, face;
vec3 step_right_mm, step_up_mm;  // in the world, from this pixel's place to its neighbours' on the same plane

void look(vec3 eye_mm) {
  vec4 place = texelFetch(place_picture, ivec2(gl_FragCoord.xy), 0);
  vec4 normal = texelFetch(normal_picture, ivec2(gl_FragCoord.xy), 0);
  in_bone_mm = place.xyz;
  openness = place.w;
  face = normal.w;
  plain_normal = normalize(normal.xyz);
  in_world_mm = (world_from_bone * vec4(in_bone_mm, 1.0)).xyz;
  in_tool_mm = (tool_from_bone * vec4(in_bone_mm, 1.0)).xyz;
  vec3 back = eye_mm - in_world_mm;
  float distance_mm = length(back);
  to_eye = back / distance_mm;
  // Not by the neighbours' own places: those may be another surface's.
  vec3 slide = to_eye / max(dot(plain_normal, to_eye), 0.08);
  step_right_mm = distance_mm * (pixel_right - slide * dot(plain_normal, pixel_right));
  step_up_mm = distance_mm * (pixel_up - slide * dot(plain_normal, pixel_up));
}

// By how much a plane's signed distance changes from pixel to pixel.
float change_over_pixel(vec3 plane_normal_in_world) {
  return max(length(vec2(dot(plane_normal_in_world, step_right_mm),
                         dot(plane_normal_in_world, step_up_mm))),
             1e-5);
}
