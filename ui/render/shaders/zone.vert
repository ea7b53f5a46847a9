// A capsule: a sphere's direction, moved along the axis where it belongs to the far end.
layout(location = 0) in vec4 direction_and_end;

uniform mat4 clip_from_world;
uniform mat4 world_from_zone;  // z along the axis, origin at its beginning
uniform vec2 radius_and_length_mm;

out vec3 in_world_mm, normal_in_world;
out float along_mm;

void main() {
  vec3 way = direction_and_end.xyz;
  float begin = radius_and_length_mm.y * direction_and_end.w;
  vec3 in_zone_mm = radius_and_length_mm.x * way + vec3(0.0, 0.0, begin);
  in_world_mm = (world_from_zone * vec4(in_zone_mm, 1.0)).xyz;
  normal_in_world = mat3(world_from_zone) * way;
  along_mm = in_zone_mm.z;
  gl_Position = clip_from_world * vec4(in_world_mm, 1.0);
}
