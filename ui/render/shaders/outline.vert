// A surface moved outwards by some pixels: of it only what faces away is drawn.
layout(location = 0) in vec3 point_in_bone_mm;
layout(location = 1) in vec4 normal_and_openness;

uniform mat4 clip_from_bone;
uniform vec4 width;  // of the line in clip coordinates, x and y; pixels of the picture

void main() {
  vec4 clip = clip_from_bone * vec4(point_in_bone_mm, 1.0);
  vec2 way = (clip_from_bone * vec4(normal_and_openness.xyz, 0.0)).xy * width.zw;
  clip.xy += way / max(length(way), 1e-6) * width.xy * clip.w;
  gl_Position = clip;
}
