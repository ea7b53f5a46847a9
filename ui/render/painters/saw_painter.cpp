// The saw, its blur, and blades that are only shown. Models are made again where the blade is
// another one. The handpiece gives way on the line from the eye to the teeth: else it would hide
// the cut.
#include "ui/render/painters/saw_painter.h"

#include <array>

namespace hallux::ui {

namespace {

/// The blade turned about its pivot by a share of its swing.
RigidTransform swung(const SawInScene& saw, double share) {
  const Vec3 pivot_mm(pivot_x_mm(saw.blade), 0.0, 0.0);
  const Quat turn = rotation_about(Vec3(0.0, 0.0, 1.0), share * swing_rad);
  return saw.world_from_tool * RigidTransform{turn, pivot_mm - turn * pivot_mm};
}

/// A ghost is as thick as its kerf usually is, whatever its steel.
constexpr double ghost_thickness_mm = 0.5;

}  // namespace

SawPainter::SawPainter(const NoiseTextures& noise, PartPainter& parts)
    : noise_(noise), parts_(parts), blade_("tool.vert", "tool.frag", "#define BLADE\n") {}

SawPainter::Model& SawPainter::model_of(std::optional<Model>& model,
                                        const simulator::Blade& blade) {
  if (!model || model->size != blade) {
    model.emplace(Model{blade, ToolView(blade_mesh(blade)), ToolView(handpiece_mesh(blade))});
  }
  return *model;
}

void SawPainter::draw_handpiece(const Frame& frame, HandlePart which) {
  const SawInScene& saw = *frame.scene.saw;
  const std::array parts{PlacedPart{model_of(model_, saw.blade).handpiece, saw.world_from_tool}};
  parts_.draw_handle(frame, handle_of(saw), parts, which);
}

void SawPainter::draw_blade(const Frame& frame) {
  const SawInScene& saw = *frame.scene.saw;
  const ToolView& view = model_of(model_, saw.blade).blade;
  noise_.bind();
  blade_.use();
  set_part(blade_, frame, saw.is_running ? swung(saw, saw.swing) : saw.world_from_tool);
  view.draw();
}

void SawPainter::draw(const Frame& frame) {
  if (!frame.scene.saw) return;
  draw_handpiece(frame, HandlePart::Whole);
  draw_blade(frame);
}

void SawPainter::draw_ghosts(const Frame& frame) {
  if (frame.scene.saw && frame.scene.saw->is_running) {
    // A blade that swings faster than pictures come is a blur between its ends.
    const SawInScene& saw = *frame.scene.saw;
    const Model& model = model_of(model_, saw.blade);
    for (const double end : {-1.0, 1.0}) {
      parts_.draw_ghost(frame, {model.blade, swung(saw, end)}, Float4(0.74F, 0.77F, 0.80F, 0.34F));
    }
  }
  for (const BladeGhost& ghost : frame.scene.blade_ghosts) {
    simulator::Blade blade = ghost.blade;
    blade.thickness_mm = ghost_thickness_mm;
    parts_.draw_ghost(frame, {model_of(ghost_model_, blade).blade, ghost.world_from_tool},
                      Float4(colour_of(frame.palette, ghost.ink), 0.80F));
  }
}

void SawPainter::draw_seen_through(const Frame& frame) {
  if (!frame.scene.saw) return;
  const SawInScene& saw = *frame.scene.saw;
  const std::array parts{PlacedPart{model_of(model_, saw.blade).handpiece, saw.world_from_tool}};
  parts_.draw_seen_through(frame, handle_of(saw), parts);
}

std::size_t SawPainter::triangle_count(const Scene& scene) const noexcept {
  if (!scene.saw || !model_) return 0;
  return model_->blade.triangle_count() + model_->handpiece.triangle_count();
}

}  // namespace hallux::ui
