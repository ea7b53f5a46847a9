layout(location = 0) in vec3 point_in_bone_mm;
layout(location = 1) in vec4 normal_and_openness;
layout(location = 2) in vec2 kerf_and_side;

uniform mat4 clip_from_bone;
uniform mat4 world_from_bone;
uniform vec4 cut_away;  // normal in the bone frame, offset; counts only while the clip distance is on

out vec3 in_bone_mm, normal_in_world;
out float openness;
flat out float face;

void main() {
  vec4 point = vec4(point_in_bone_mm, 1.0);
  in_bone_mm = point_in_bone_mm;
  normal_in_world = mat3(world_from_bone) * normal_and_openness.xyz;
  openness = normal_and_openness.w;
  face = 4.0 * kerf_and_side.x + kerf_and_side.y;
  gl_ClipDistance[0] = cut_away.w - dot(cut_away.xyz, point_in_bone_mm);
  gl_Position = clip_from_bone * point;
}
