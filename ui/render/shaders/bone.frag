// Only what is where: light is laid on it later, once a pixel. Bones have many small triangles, and a dear shader would be run
// several times over at their borders.
in vec3 in_bone_mm, normal_in_world;
in float openness;
flat in float face;
layout(location = 0) out vec4 place_and_openness;
layout(location = 1) out vec4 normal_and_face;

const float inside = -100.0;  // the face of a skin that is seen from within

void main() {
  place_and_openness = vec4(in_bone_mm, openness);
  normal_and_face = vec4(gl_FrontFacing ? normal_in_world : -normal_in_world,
                         gl_FrontFacing ? face : inside);
}
