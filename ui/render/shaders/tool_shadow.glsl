// The shadow of the tool in the hand by formula: the blade is a rectangle, a shaft in its place a thin capsule, the handpiece a
// thick one. Softer the further away it falls from.
uniform vec3 key_in_tool;   // direction towards the key light, tool frame
uniform vec4 blade_shadow;  // depth, half width [mm], 1 or (no tool) 0, where the handpiece begins
uniform float shaft_shadow;  // radius of what is in the blade's place [mm]; 0: there is a blade

float key_share_at(vec3 in_tool_mm) {
  if (blade_shadow.z <= 0.0) return 1.0;
  float to_plane = -in_tool_mm.z / (abs(key_in_tool.z) < 0.02 ? 0.02 : key_in_tool.z);
  vec2 hit = in_tool_mm.xy + to_plane * key_in_tool.xy;
  vec2 outside = max(vec2(-blade_shadow.x - hit.x, -blade_shadow.y - hit.y),
                     vec2(hit.x, hit.y - blade_shadow.y));
  float soft = 0.25 + 0.10 * abs(to_plane);
  float blade = (1.0 - smoothstep(-soft, soft, max(outside.x, outside.y))) * step(0.15, to_plane);

  // The nearest pass of the ray to the handpiece's axis, which is the tool's x axis.
  vec2 across = in_tool_mm.yz, way = key_in_tool.yz;
  float along_ray = max(-dot(across, way) / max(dot(way, way), 0.01), 0.0);
  vec3 passed = in_tool_mm + along_ray * key_in_tool;
  float beyond = max(passed.x - blade_shadow.w, 0.0);
  float clearance = length(vec3(passed.yz, beyond)) - 7.5;
  float handpiece = 1.0 - smoothstep(-1.0 - 0.05 * along_ray, 1.0 + 0.10 * along_ray, clearance);
  float tip = blade;
  if (shaft_shadow > 0.0) {
    float off = length(vec3(passed.yz, max(passed.x, 0.0))) - shaft_shadow;
    float shaft_soft = 0.12 + 0.10 * along_ray;
    tip = (1.0 - smoothstep(-shaft_soft, shaft_soft, off)) * step(0.15, along_ray);
  }
  return 1.0 - max(tip, handpiece * step(0.5, along_ray));
}
