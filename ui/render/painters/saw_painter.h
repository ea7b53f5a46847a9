/// Draws the saw and the ghosts of blades.
#pragma once

#include <optional>

#include "ui/render/painters/part_painter.h"
#include "ui/render/scene/tool_model.h"

namespace hallux::ui {

class SawPainter {
 public:
  /// Borrows both.
  SawPainter(const NoiseTextures& noise, PartPainter& parts);

  void draw(const Frame& frame);
  void draw_blade(const Frame& frame);
  void draw_handpiece(const Frame& frame, HandlePart which);
  /// After everything that is not translucent.
  void draw_ghosts(const Frame& frame);
  /// The part of the handpiece that would hide the teeth, after everything that may lie behind it.
  void draw_seen_through(const Frame& frame);
  std::size_t triangle_count(const Scene& scene) const noexcept;

 private:
  struct Model {
    simulator::Blade size;
    ToolView blade, handpiece;
  };

  /// The model in that place, made anew where it is of another blade.
  static Model& model_of(std::optional<Model>& model, const simulator::Blade& blade);

  const NoiseTextures& noise_;
  PartPainter& parts_;
  ShaderProgram blade_;
  std::optional<Model> model_, ghost_model_;
};

}  // namespace hallux::ui
