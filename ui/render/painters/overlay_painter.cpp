#include "ui/render/painters/overlay_painter.h"

#include <epoxy/gl.h>

#include <cstddef>
#include <vector>

#include "ui/render/scene/plane_fade.h"

namespace hallux::ui {

OverlayPainter::OverlayPainter()
    : ground_("part.vert", "ground.frag"),
      chip_("chip.vert", "chip.frag"),
      plane_("plane.vert", "plane.frag"),
      mark_("mark.vert", "mark.frag") {}

void OverlayPainter::draw_ground(const Frame& frame, std::span<const PixelBox> boxes) {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_FALSE);
  ground_.use();
  set_ground(ground_, frame);
  set_boxes(ground_, boxes, frame.target.size);
  glBindVertexArray(no_attributes_.name());
  draw_boxes(boxes);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

void OverlayPainter::fill_points() {
  points_.upload();
  glBindVertexArray(points_array_.name());
  if (pointed_at_ == points_.name()) return;
  pointed_at_ = points_.name();
  constexpr auto stride = static_cast<GLsizei>(sizeof(PointVertex));
  glBindBuffer(GL_ARRAY_BUFFER, pointed_at_);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride, nullptr);
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(
      1, 2, GL_FLOAT, GL_FALSE, stride,
      static_cast<const std::byte*>(nullptr) + offsetof(PointVertex, size_and_wetness));
}

void OverlayPainter::draw_chips(const Frame& frame) {
  if (frame.scene.chips.empty()) return;
  std::vector<PointVertex> chips;
  chips.reserve(frame.scene.chips.size());
  for (const Chip& chip : frame.scene.chips) {
    chips.push_back({to_float(chip.place_mm), Float2(chip.size_mm, chip.wetness)});
  }
  points_.assign(chips);
  fill_points();
  chip_.use();
  set_light(chip_, frame);
  chip_.set("clip_from_world", to_float(frame.clip_from_world));
  const double focal = frame.view.clip_from_view[1][1];
  chip_.set("pixels_at_one", static_cast<float>(0.5 * focal * frame.target.size.height));
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(chips.size()));
  glDisable(GL_PROGRAM_POINT_SIZE);
}

void OverlayPainter::draw_planes(const Frame& frame) {
  if (frame.scene.planes.empty()) return;
  plane_.use();
  plane_.set("pixel_scale", static_cast<float>(frame.pixel_scale));
  glBindVertexArray(no_attributes_.name());
  glEnable(GL_BLEND);
  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  for (const PlaneGhost& plane : frame.scene.planes) {
    const double share = face_on_share(plane.world_from_plane, frame.view.eye_in_world_mm);
    if (share <= 0.0) continue;
    const DoubleMatrix4 world_from_plane = matrix_of(plane.world_from_plane);
    plane_.set("clip_from_plane", to_float(frame.clip_from_world * world_from_plane));
    plane_.set("half_mm", to_float(plane.half_mm));
    plane_.set("ink", colour_of(frame.palette, plane.ink));
    plane_.set("fill_and_line", Float2(share * Vec2(plane.is_filled ? 0.13 : 0.0, 0.62)));
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  }
  glEnable(GL_CULL_FACE);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void OverlayPainter::draw_marks(const Frame& frame) {
  if (frame.scene.marks.empty()) return;
  mark_.use();
  mark_.set("clip_from_world", to_float(frame.clip_from_world));
  mark_.set("rim", frame.palette.ground_rim);
  glEnable(GL_BLEND);
  glEnable(GL_PROGRAM_POINT_SIZE);
  glDisable(GL_DEPTH_TEST);
  for (const Mark& mark : frame.scene.marks) {
    const PointVertex place{to_float(mark.place_mm), {}};
    points_.assign(std::span(&place, 1));
    fill_points();
    mark_.set("size_pixels", static_cast<float>(2.0 * mark.radius_pixels * frame.pixel_scale));
    mark_.set("shape", static_cast<int>(mark.shape));
    mark_.set("ink", colour_of(frame.palette, mark.ink));
    glDrawArrays(GL_POINTS, 0, 1);
  }
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_PROGRAM_POINT_SIZE);
  glDisable(GL_BLEND);
}

}  // namespace hallux::ui
