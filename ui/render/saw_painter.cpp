#include "ui/render/saw_painter.h"

#include <epoxy/gl.h>

#include <cstddef>

namespace hallux::ui {

namespace {

/// OpenGL takes places in a buffer as pointers from nowhere.
const void* offset_of(std::size_t bytes) { return static_cast<const std::byte*>(nullptr) + bytes; }

/// The blade turned about its pivot by a share of its swing.
RigidTransform swung(const SawInScene& saw, double share) {
  const Vec3 pivot_mm(pivot_x_mm(saw.blade), 0.0, 0.0);
  const Quat turn = rotation_about(Vec3(0.0, 0.0, 1.0), share * swing_rad);
  return saw.world_from_tool * RigidTransform{turn, pivot_mm - turn * pivot_mm};
}

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

SawPainter::SawPainter(const NoiseTextures& noise)
    : noise_(noise),
      blade_("tool.vert", "tool.frag", "#define BLADE\n"),
      handpiece_("tool.vert", "tool.frag"),
      ghost_("ghost.vert", "ghost.frag") {}

SawPainter::Model& SawPainter::model_of(const simulator::BladeSize& size, double thickness_mm) {
  const bool is_same = model_ && model_->size.width_mm == size.width_mm &&
                       model_->size.depth_mm == size.depth_mm &&
                       model_->thickness_mm == thickness_mm;
  if (!is_same) {
    model_.emplace(Model{size, thickness_mm, ToolView(blade_mesh(size, thickness_mm)),
                         ToolView(handpiece_mesh(size))});
  }
  return *model_;
}

void SawPainter::draw_part(ShaderProgram& program, const Frame& frame, const ToolView& part,
                           const RigidTransform& world_from_part) {
  const DoubleMatrix4 matrix = matrix_of(world_from_part);
  program.use();
  set_light(program, frame);
  program.set("noise", noise_unit);
  program.set("world_from_tool", to_float(matrix));
  program.set("clip_from_tool", to_float(frame.clip_from_world * matrix));
  part.draw();
}

void SawPainter::draw_ghost(const Frame& frame, const ToolView& part,
                            const RigidTransform& world_from_part, const Float4& ink) {
  ghost_.use();
  ghost_.set("ink", ink);
  ghost_.set("clip_from_ghost", to_float(frame.clip_from_world * matrix_of(world_from_part)));
  // Depth first: of what lies behind each other in the ghost only the nearest is seen through. A little behind its place:
  // where the blade itself stands, the blade is seen.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 8.0F);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  part.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  part.draw();
  glDisable(GL_BLEND);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void SawPainter::draw(const Frame& frame) {
  if (!frame.scene.saw) return;
  const SawInScene& saw = *frame.scene.saw;
  const Model& model = model_of(saw.blade, saw.thickness_mm);
  noise_.bind();
  draw_part(handpiece_, frame, model.handpiece, saw.world_from_tool);
  draw_part(blade_, frame, model.blade,
            saw.is_running ? swung(saw, saw.swing) : saw.world_from_tool);
}

void SawPainter::draw_ghosts(const Frame& frame) {
  if (frame.scene.saw && frame.scene.saw->is_running) {
    // A blade that swings faster than pictures come is a blur between its ends.
    const SawInScene& saw = *frame.scene.saw;
    const Model& model = model_of(saw.blade, saw.thickness_mm);
    for (const double end : {-1.0, 1.0}) {
      draw_ghost(frame, model.blade, swung(saw, end), Float4(0.74F, 0.77F, 0.80F, 0.34F));
    }
  }
  for (const BladeGhost& ghost : frame.scene.blade_ghosts) {
    if (!ghost_model_ || ghost_model_->size.width_mm != ghost.blade.width_mm ||
        ghost_model_->size.depth_mm != ghost.blade.depth_mm) {
      ghost_model_.emplace(Model{ghost.blade, 0.5, ToolView(blade_mesh(ghost.blade, 0.5)),
                                 ToolView(handpiece_mesh(ghost.blade))});
    }
    draw_ghost(frame, ghost_model_->blade, ghost.world_from_tool,
               Float4(colour_of(frame.palette, ghost.ink), 0.80F));
  }
}

std::size_t SawPainter::triangle_count() const noexcept {
  return model_ ? model_->blade.triangle_count() + model_->handpiece.triangle_count() : 0;
}

}  // namespace hallux::ui
