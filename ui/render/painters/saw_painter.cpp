// The saw, its blur, and blades that are only shown. Models are made again where the blade is
// another one. A part that is seen through is drawn twice, depth and then colour, so that only its
// nearest surface counts. The handpiece gives way on the line from the eye to the teeth: else it
// would hide the cut.
#include "ui/render/painters/saw_painter.h"

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

/// Within the first of the line from the eye to the teeth the handpiece is seen through, beyond the
/// second it is whole.
constexpr double clear_within_mm = 12.0, whole_beyond_mm = 19.0;
constexpr double widest_handle_mm = 9.0;
/// A ghost is as thick as its kerf usually is, whatever its steel.
constexpr double ghost_thickness_mm = 0.5;

/// Sets what the shader of a tool's part needs of the picture.
void set_part(ShaderProgram& program, const Frame& frame, const RigidTransform& world_from_part) {
  const DoubleMatrix4 matrix = matrix_of(world_from_part);
  set_light(program, frame);
  program.set("noise", noise_unit);
  program.set("world_from_tool", to_float(matrix));
  program.set("clip_from_tool", to_float(frame.clip_from_world * matrix));
}

/// Draws first the depth, then the colour, so that of parts behind each other only the nearest is
/// seen through.
void draw_nearest_only(const ToolView& part) {
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  part.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_BLEND);
  part.draw();
  glDisable(GL_BLEND);
}

/// Around the part of the handpiece of which something is seen through; empty where it is whole.
Box seen_through_part(const SawInScene& saw, const EyeView& view) {
  if (saw.handpiece_presence >= 1.0) return before_the_teeth(saw, view.eye_in_world_mm);
  const double pivot_mm = pivot_x_mm(saw.blade), side_mm = widest_handle_mm + 1.0;
  Box box;
  box.add(Vec3(pivot_mm - cable_end_mm - 1.0, -side_mm, -side_mm));
  box.add(Vec3(pivot_mm + side_mm, side_mm, side_mm));
  return box;
}

bool is_whole(const SawInScene& saw, const EyeView& view) {
  return seen_through_part(saw, view).is_empty();
}

}  // namespace

Box before_the_teeth(const SawInScene& saw, const Vec3& eye_mm) noexcept {
  const Vec3 teeth_mm = saw.world_from_tool.translation_mm;
  const Vec3 to_teeth = glm::normalize(teeth_mm - eye_mm);
  constexpr double step_mm = 4.0, reach_mm = widest_handle_mm + step_mm;
  const double pivot_mm = pivot_x_mm(saw.blade);
  Box box;
  for (double along_mm = pivot_mm; along_mm > pivot_mm - cable_end_mm; along_mm -= step_mm) {
    const Vec3 from_teeth = transform_direction(saw.world_from_tool, Vec3(along_mm, 0.0, 0.0));
    const bool is_nearer = glm::dot(from_teeth, to_teeth) < reach_mm;
    const double beside_mm = glm::length(glm::cross(from_teeth, to_teeth));
    if (!is_nearer || beside_mm > whole_beyond_mm + reach_mm) continue;
    box.add(Vec3(along_mm - reach_mm, -reach_mm, -reach_mm));
    box.add(Vec3(along_mm + reach_mm, reach_mm, reach_mm));
  }
  return box;
}

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
      seen_through_("tool.vert", "tool.frag", "#define SEEN_THROUGH\n"),
      ghost_("ghost.vert", "ghost.frag") {}

SawPainter::Model& SawPainter::model_of(std::optional<Model>& model,
                                        const simulator::Blade& blade) {
  if (!model || model->size != blade) {
    model.emplace(Model{blade, ToolView(blade_mesh(blade)), ToolView(handpiece_mesh(blade))});
  }
  return *model;
}

void SawPainter::draw_part(ShaderProgram& program, const Frame& frame, const ToolView& part,
                           const RigidTransform& world_from_part) {
  program.use();
  set_part(program, frame, world_from_part);
  part.draw();
}

void SawPainter::draw_ghost(const Frame& frame, const ToolView& part,
                            const RigidTransform& world_from_part, const Float4& ink) {
  ghost_.use();
  ghost_.set("ink", ink);
  ghost_.set("clip_from_ghost", to_float(frame.clip_from_world * matrix_of(world_from_part)));
  // Depth first: of what lies behind each other in the ghost only the nearest is seen through. A
  // little behind its place: where the blade itself stands, the blade is seen.
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.0F, 8.0F);
  draw_nearest_only(part);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void SawPainter::draw_handpiece(const Frame& frame, const ToolView& view, HandpiecePart part) {
  const SawInScene& saw = *frame.scene.saw;
  const bool is_seen_through = part == HandpiecePart::SeenThrough;
  seen_through_.use();
  seen_through_.set("teeth_mm", to_float(saw.world_from_tool.translation_mm));
  seen_through_.set("reach_mm", to_float(Vec2(clear_within_mm, whole_beyond_mm)));
  seen_through_.set("handpiece_presence", static_cast<float>(saw.handpiece_presence));
  seen_through_.set("is_translucent_part", is_seen_through ? 1.0F : 0.0F);
  seen_through_.set("whole_from", part == HandpiecePart::MostlyThere ? 0.5F : 1.0F);
  set_part(seen_through_, frame, saw.world_from_tool);
  if (is_seen_through) {
    draw_nearest_only(view);
  } else {
    view.draw();
  }
}

void SawPainter::draw_handpiece(const Frame& frame, HandpiecePart part) {
  const SawInScene& saw = *frame.scene.saw;
  noise_.bind();
  const ToolView& view = model_of(model_, saw.blade).handpiece;
  if (is_whole(saw, frame.view)) {
    draw_part(handpiece_, frame, view, saw.world_from_tool);
  } else {
    draw_handpiece(frame, view, part);
  }
}

void SawPainter::draw_blade(const Frame& frame) {
  const SawInScene& saw = *frame.scene.saw;
  noise_.bind();
  draw_part(blade_, frame, model_of(model_, saw.blade).blade,
            saw.is_running ? swung(saw, saw.swing) : saw.world_from_tool);
}

void SawPainter::draw(const Frame& frame) {
  if (!frame.scene.saw) return;
  draw_handpiece(frame, HandpiecePart::Whole);
  draw_blade(frame);
}

void SawPainter::draw_ghosts(const Frame& frame) {
  if (frame.scene.saw && frame.scene.saw->is_running) {
    // A blade that swings faster than pictures come is a blur between its ends.
    const SawInScene& saw = *frame.scene.saw;
    const Model& model = model_of(model_, saw.blade);
    for (const double end : {-1.0, 1.0}) {
      draw_ghost(frame, model.blade, swung(saw, end), Float4(0.74F, 0.77F, 0.80F, 0.34F));
    }
  }
  for (const BladeGhost& ghost : frame.scene.blade_ghosts) {
    simulator::Blade blade = ghost.blade;
    blade.thickness_mm = ghost_thickness_mm;
    draw_ghost(frame, model_of(ghost_model_, blade).blade, ghost.world_from_tool,
               Float4(colour_of(frame.palette, ghost.ink), 0.80F));
  }
}

void SawPainter::draw_seen_through(const Frame& frame) {
  if (!frame.scene.saw) return;
  const SawInScene& saw = *frame.scene.saw;
  if (is_whole(saw, frame.view)) return;
  noise_.bind();
  set_scissor(pixels_of(seen_through_part(saw, frame.view), saw.world_from_tool, frame.view,
                        frame.target.size));
  draw_handpiece(frame, model_of(model_, saw.blade).handpiece, HandpiecePart::SeenThrough);
  set_scissor(all_of(frame.target.size));
}

std::size_t SawPainter::triangle_count() const noexcept {
  return model_ ? model_->blade.triangle_count() + model_->handpiece.triangle_count() : 0;
}

}  // namespace hallux::ui
