// A part that is seen through is drawn twice, depth and then colour, so that only its nearest
// surface counts.
#include "ui/render/painters/part_painter.h"

#include <epoxy/gl.h>

#include <cstddef>

#include "ui/render/painters/pixel_box.h"

namespace hallux::ui {

namespace {

/// OpenGL takes places in a buffer as pointers from nowhere.
const void* offset_of(std::size_t bytes) { return static_cast<const std::byte*>(nullptr) + bytes; }

}  // namespace

ToolView::ToolView(const ToolMesh& mesh) {
  vertices_.assign(mesh.vertices);
  vertices_.upload();
  triangles_.assign(mesh.triangles);
  triangles_.upload();
  constexpr auto stride = static_cast<GLsizei>(sizeof(ToolVertex));
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, stride,
                        offset_of(offsetof(ToolVertex, point_in_tool_mm)));
  glEnableVertexAttribArray(1);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride, offset_of(offsetof(ToolVertex, normal)));
  glEnableVertexAttribArray(2);
  glVertexAttribPointer(2, 1, GL_FLOAT, GL_FALSE, stride,
                        offset_of(offsetof(ToolVertex, material)));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.name());
  glBindVertexArray(0);
}

void ToolView::draw() const {
  glBindVertexArray(array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * triangles_.size()), GL_UNSIGNED_INT,
                 nullptr);
  glBindVertexArray(0);
}

void set_part(ShaderProgram& program, const Frame& frame, const RigidTransform& world_from_part) {
  const DoubleMatrix4 matrix = matrix_of(world_from_part);
  set_light(program, frame);
  program.set("noise", noise_unit);
  program.set("world_from_tool", to_float(matrix));
  program.set("clip_from_tool", to_float(frame.clip_from_world * matrix));
}

PartPainter::PartPainter(const NoiseTextures& noise)
    : noise_(noise),
      whole_("tool.vert", "tool.frag"),
      seen_through_("tool.vert", "tool.frag", "#define SEEN_THROUGH\n"),
      ghost_("ghost.vert", "ghost.frag") {}

void PartPainter::draw(const Frame& frame, const PlacedPart& part) {
  noise_.bind();
  whole_.use();
  set_part(whole_, frame, part.world_from_part);
  part.view.draw();
}

void PartPainter::set_seen_through(const Frame& frame, const Handle& handle, HandlePart which) {
  noise_.bind();
  seen_through_.use();
  set_light(seen_through_, frame);
  seen_through_.set("teeth_mm", to_float(handle.world_from_tool.translation_mm));
  seen_through_.set("reach_mm", to_float(Vec2(clear_within_mm, whole_beyond_mm)));
  seen_through_.set("nearer_range_mm", Float2(handle.keeps_mm, handle.keeps_mm + 4.0));
  seen_through_.set("handpiece_presence", static_cast<float>(handle.presence));
  seen_through_.set("is_translucent_part", which == HandlePart::SeenThrough ? 1.0F : 0.0F);
  seen_through_.set("whole_from", which == HandlePart::MostlyThere ? 0.5F : 1.0F);
}

void PartPainter::draw_handle(const Frame& frame, const Handle& handle,
                              std::span<const PlacedPart> parts, HandlePart which) {
  if (seen_through_part(handle, frame.view).is_empty()) {
    for (const PlacedPart& part : parts) draw(frame, part);
    return;
  }
  set_seen_through(frame, handle, which);
  const auto draw_parts = [&] {
    for (const PlacedPart& part : parts) {
      set_part(seen_through_, frame, part.world_from_part);
      part.view.draw();
    }
  };
  if (which != HandlePart::SeenThrough) return draw_parts();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  draw_parts();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  draw_parts();
  glDisable(GL_BLEND);
}

void PartPainter::draw_seen_through(const Frame& frame, const Handle& handle,
                                    std::span<const PlacedPart> parts) {
  const Box box = seen_through_part(handle, frame.view);
  if (box.is_empty()) return;
  set_scissor(pixels_of(box, handle.world_from_tool, frame.view, frame.target.size));
  draw_handle(frame, handle, parts, HandlePart::SeenThrough);
  set_scissor(all_of(frame.target.size));
}

void PartPainter::draw_ghost(const Frame& frame, const PlacedPart& part, const Float4& ink) {
  ghost_.use();
  ghost_.set("ink", ink);
  ghost_.set("clip_from_ghost", to_float(frame.clip_from_world * matrix_of(part.world_from_part)));
  // Depth first: of what lies behind each other in the ghost only the nearest is seen through. A
  // little behind its place: where the part itself stands, the part is seen.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 8.0F);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  part.view.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  part.view.draw();
  glDisable(GL_BLEND);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

}  // namespace hallux::ui
