// How much of the handpiece is there: what lies nearer than the teeth, within reach of the line from the eye to them, is
// seen through.
uniform vec3 teeth_mm;  // in the world
uniform vec2 reach_mm;  // least and full presence, distances from the line
uniform vec2 nearer_range_mm;  // full and least presence, by how much nearer to the eye than the tip
uniform float handpiece_presence;  // of all of it

float presence_at(vec3 in_world_mm, vec3 eye_mm) {
  vec3 to_teeth = normalize(teeth_mm - eye_mm), from_teeth = in_world_mm - teeth_mm;
  float beside_mm = length(cross(from_teeth, to_teeth));
  float nearer_mm = -dot(from_teeth, to_teeth);
  float clear = (1.0 - smoothstep(reach_mm.x, reach_mm.y, beside_mm)) * smoothstep(nearer_range_mm.x, nearer_range_mm.y, nearer_mm);
  return min(1.0 - 0.86 * clear, handpiece_presence);
}
