/// Draws wires and screws that stand in bone, or are planned to.
#pragma once

#include <vector>

#include "ui/render/painters/part_painter.h"

namespace hallux::ui {

class ImplantPainter {
 public:
  /// Borrows it.
  explicit ImplantPainter(PartPainter& parts);

  /// Those that are planned, translucent over the bones they are seen through.
  /// ensures the depths stay those of the shapes
  void draw_planned(const Frame& frame);
  /// The others; bone hides them.
  void draw_standing(const Frame& frame);
  std::size_t triangle_count(const Scene& scene) const noexcept;

 private:
  struct Model {
    simulator::Tool tool;
    ToolView view;
  };

  const ToolView& view_of(const Scene& scene, const simulator::Tool& tool);
  void draw_planned(const Frame& frame, const ImplantInScene& implant);

  PartPainter& parts_;
  ShaderProgram planned_;
  std::vector<Model> models_;
};

/// Around it; tool frame.
Box box_of(const simulator::Tool& implant) noexcept;

}  // namespace hallux::ui
