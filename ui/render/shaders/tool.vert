layout(location = 0) in vec3 point_in_tool_mm;
layout(location = 1) in vec3 normal_in_tool;
layout(location = 2) in float material_of;

uniform mat4 clip_from_tool, world_from_tool;

out vec3 in_tool_mm, in_world_mm, normal_in_world;
flat out float material;
flat out float is_face;

void main() {
  in_tool_mm = point_in_tool_mm;
  in_world_mm = (world_from_tool * vec4(point_in_tool_mm, 1.0)).xyz;
  normal_in_world = mat3(world_from_tool) * normal_in_tool;
  material = material_of;
  is_face = step(0.9, abs(normal_in_tool.z));
  gl_Position = clip_from_tool * vec4(point_in_tool_mm, 1.0);
}
