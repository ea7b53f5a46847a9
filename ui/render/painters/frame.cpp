#include "ui/render/painters/frame.h"

#include <epoxy/gl.h>

#include <array>

#include "simulator/base/check.h"
#include "ui/render/painters/pixel_box.h"

namespace hallux::ui {

namespace {

/// The view's axes: x right, y up, z to the viewer.
Float3 direction(const EyeView& view, const Vec3& in_view) {
  return to_float(view.world_from_view * glm::normalize(in_view));
}

}  // namespace

Frame frame_of(const Scene& scene, const EyeView& view, const PictureBuffers& buffers,
               double pixel_scale) noexcept {
  return {scene,
          view,
          buffers.picture(),
          pixel_scale,
          view.clip_from_world(),
          palette_of(scene.ground),
          direction(view, Vec3(-0.55, 0.75, 0.60)),
          buffers.shapes(),
          buffers.place_texture(),
          buffers.normal_texture()};
}

void begin_drawing(PixelSize size) {
  glViewport(0, 0, size.width, size.height);
  glEnable(GL_SCISSOR_TEST);
  set_scissor(all_of(size));
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  glStencilMask(0xff);
  glDisable(GL_BLEND);
  glBlendEquation(GL_FUNC_ADD);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_BACK);
  glFrontFace(GL_CCW);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
  glClearDepth(1.0);
  glClearStencil(0);
}

void end_drawing() {
  glBindVertexArray(0);
  glUseProgram(0);
  glDisable(GL_SCISSOR_TEST);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
}

void set_boxes(ShaderProgram& program, std::span<const PixelBox> boxes, PixelSize size) {
  CHECK(boxes.size() <= boxes_at_most);
  std::array<Float4, boxes_at_most> in_clip{};
  const Vec2 pixels(size.width, size.height);
  const auto clip_of = [&](int x, int y) { return 2.0 * Vec2(x, y) / pixels - 1.0; };
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Vec2 low = clip_of(boxes[i].left, boxes[i].bottom);
    const Vec2 high = clip_of(boxes[i].right, boxes[i].top);
    in_clip[i] = Float4(low.x, low.y, high.x, high.y);
  }
  program.set("boxes", std::span{in_clip}.first(boxes.size()));
}

void draw_boxes(std::span<const PixelBox> boxes) {
  glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(6 * boxes.size()));
}

void set_light(ShaderProgram& program, const Frame& frame) {
  const EyeView& view = frame.view;
  program.set("eye_mm", to_float(view.eye_in_world_mm));
  program.set("key_light", frame.key_light);
  program.set("fill_light", direction(view, Vec3(0.90, -0.10, 0.45)));
  program.set("rim_light", direction(view, Vec3(0.30, 0.55, -0.75)));
  program.set("view_up", direction(view, Vec3(0.0, 1.0, 0.0)));
  program.set("view_right", direction(view, Vec3(1.0, 0.0, 0.0)));
  program.set("view_back", direction(view, Vec3(0.0, 0.0, 1.0)));
  program.set("is_light_ground", frame.scene.ground == Ground::Light ? 1.0F : 0.0F);
}

void set_seen_bone(ShaderProgram& program, const Frame& frame) {
  const DoubleMatrix4& clip = frame.view.clip_from_view;
  const Vec3 right = frame.view.world_from_view * Vec3(1.0, 0.0, 0.0);
  const Vec3 up = frame.view.world_from_view * Vec3(0.0, 1.0, 0.0);
  program.set("pixel_right", to_float(right * (2.0 / (clip[0][0] * frame.target.size.width))));
  program.set("pixel_up", to_float(up * (2.0 / (clip[1][1] * frame.target.size.height))));
  program.set("place_picture", place_unit);
  program.set("normal_picture", normal_unit);
}

void set_ground(ShaderProgram& program, const Frame& frame) {
  program.set("ground_middle", frame.palette.ground_middle);
  program.set("ground_rim", frame.palette.ground_rim);
  program.set("ground_place", to_float(frame.scene.light_place));
  program.set("picture", Float4(frame.target.left, frame.target.bottom,
                                1.0F / static_cast<float>(frame.target.size.width),
                                1.0F / static_cast<float>(frame.target.size.height)));
  program.set("picture_aspect", static_cast<float>(frame.view.width_over_height));
}

}  // namespace hallux::ui
