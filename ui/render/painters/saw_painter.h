/// Draws the saw and the ghosts of blades.
#pragma once

#include <optional>

#include "ui/render/gl/display_buffer.h"
#include "ui/render/painters/frame.h"
#include "ui/render/painters/noise_textures.h"
#include "ui/render/painters/pixel_box.h"
#include "ui/render/scene/tool_model.h"

namespace hallux::ui {

/// One part of a tool on the card.
class ToolView {
 public:
  explicit ToolView(const ToolMesh& mesh);
  void draw() const;
  std::size_t triangle_count() const noexcept { return triangles_.size(); }

 private:
  GlVertexArray array_;
  DisplayBuffer<ToolVertex> vertices_;
  DisplayBuffer<simulator::Triangle> triangles_;
};

/// What of a handpiece is drawn: where all of it is there, where at least half of it is, or where
/// it is seen through.
enum class HandpiecePart { Whole, MostlyThere, SeenThrough };

class SawPainter {
 public:
  /// Borrows the noise.
  explicit SawPainter(const NoiseTextures& noise);

  void draw(const Frame& frame);
  void draw_blade(const Frame& frame);
  void draw_handpiece(const Frame& frame, HandpiecePart part);
  /// After everything that is not translucent.
  void draw_ghosts(const Frame& frame);
  /// The part of the handpiece that would hide the teeth, after everything that may lie behind it.
  void draw_seen_through(const Frame& frame);
  std::size_t triangle_count() const noexcept;

 private:
  struct Model {
    simulator::Blade size;
    ToolView blade, handpiece;
  };

  /// The model in that place, made anew where it is of another blade.
  static Model& model_of(std::optional<Model>& model, const simulator::Blade& blade);
  void draw_part(ShaderProgram& program, const Frame& frame, const ToolView& part,
                 const RigidTransform& world_from_part);
  void draw_handpiece(const Frame& frame, const ToolView& view, HandpiecePart part);
  void draw_ghost(const Frame& frame, const ToolView& part, const RigidTransform& world_from_part,
                  const Float4& ink);

  const NoiseTextures& noise_;
  ShaderProgram blade_, handpiece_, seen_through_, ghost_;
  std::optional<Model> model_, ghost_model_;
};

/// Around the part of the handpiece that lies between the eye and the teeth, so that it is seen
/// through there; tool frame.
Box before_the_teeth(const SawInScene& saw, const Vec3& eye_mm) noexcept;

}  // namespace hallux::ui
