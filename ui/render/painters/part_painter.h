/// Draws parts of tools in steel and grip, and handles that give way. Inside this corner only.
#pragma once

#include <cstddef>
#include <span>

#include "ui/render/gl/display_buffer.h"
#include "ui/render/gl/gl_objects.h"
#include "ui/render/painters/frame.h"
#include "ui/render/painters/handle.h"
#include "ui/render/painters/noise_textures.h"
#include "ui/render/scene/tool_mesh.h"

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

/// What of a handle is drawn: where all of it is there, where at least half of it is, or where it
/// is seen through.
enum class HandlePart { Whole, MostlyThere, SeenThrough };

/// Borrowed.
struct PlacedPart {
  const ToolView& view;
  RigidTransform world_from_part;
};

class PartPainter {
 public:
  /// Borrows the noise.
  explicit PartPainter(const NoiseTextures& noise);

  void draw(const Frame& frame, const PlacedPart& part);
  void draw_handle(const Frame& frame, const Handle& handle, std::span<const PlacedPart> parts,
                   HandlePart which);
  /// What of a handle would hide its tip, after everything that may lie behind it.
  void draw_seen_through(const Frame& frame, const Handle& handle,
                         std::span<const PlacedPart> parts);
  /// All of it translucent, in one colour with its opacity; where it stands in itself it is not
  /// seen.
  void draw_ghost(const Frame& frame, const PlacedPart& part, const Float4& ink);

 private:
  void set_seen_through(const Frame& frame, const Handle& handle, HandlePart which);

  const NoiseTextures& noise_;
  ShaderProgram whole_, seen_through_, ghost_;
};

/// Sets what tool.vert and light.glsl need of the picture.
/// needs   the program is the current one
void set_part(ShaderProgram& program, const Frame& frame, const RigidTransform& world_from_part);

}  // namespace hallux::ui
