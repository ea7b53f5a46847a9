// An implant that is planned: one ink, lighter where it faces the viewer.
in vec3 in_world_mm, normal_in_world;
out vec4 colour;

uniform vec3 eye_mm;  // in the world
uniform vec4 ink;

void main() {
  float facing = max(dot(normalize(normal_in_world), normalize(eye_mm - in_world_mm)), 0.0);
  colour = vec4(ink.rgb * mix(0.50, 1.0, facing), ink.a);
}
