/// Draws wire driver, drill, screwdriver and forceps.
#pragma once

#include <array>
#include <optional>

#include "ui/render/painters/part_painter.h"

namespace hallux::ui {

class HandToolPainter {
 public:
  /// Borrows it.
  explicit HandToolPainter(PartPainter& parts) : parts_(parts) {}

  void draw(const Frame& frame);
  /// What is held: wires, bits and screws, but for the end behind where that hides the tip; jaws.
  void draw_tips(const Frame& frame, HandlePart which);
  void draw_handles(const Frame& frame, HandlePart which);
  /// A veil on a bit that turns faster than pictures come; after all that is not translucent.
  void draw_blur(const Frame& frame);
  /// What would hide a tip, after everything that may lie behind it.
  void draw_seen_through(const Frame& frame);
  std::size_t triangle_count(const Scene& scene) const noexcept;

 private:
  struct Driver {
    simulator::Tool tool;
    ToolView held, blur, chuck, body;
  };
  /// Of the arm whose point is at y > 0 and of the other.
  struct Forceps {
    std::array<ToolView, 2> jaws, handles;
  };

  /// The model, made anew where it is of another tool.
  Driver& model_of(const simulator::Tool& tool);
  Forceps& forceps();
  std::array<PlacedPart, 1> held_part(const DriverInScene& driver);
  std::array<PlacedPart, 2> handle_parts(const DriverInScene& driver);
  std::array<PlacedPart, 2> handle_parts(const ForcepsInScene& forceps);

  PartPainter& parts_;
  std::optional<Driver> driver_;
  std::optional<Forceps> forceps_;
};

}  // namespace hallux::ui
