// Boxes of the picture, two triangles each.
uniform vec4 boxes[128];  // left, bottom, right, top in clip coordinates

void main() {
  vec4 box = boxes[gl_VertexID / 6];
  int corner = gl_VertexID % 6;
  bool is_right = corner == 1 || corner == 2 || corner == 4, is_top = corner == 2 || corner == 4 || corner == 5;
  gl_Position = vec4(is_right ? box.z : box.x, is_top ? box.w : box.y, 0.0, 1.0);
}
