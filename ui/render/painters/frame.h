/// What all painters of one picture share.
#pragma once

#include <span>

#include "ui/render/gl/render_target.h"
#include "ui/render/gl/shader_program.h"
#include "ui/render/painters/picture_buffers.h"
#include "ui/render/painters/pixel_tiles.h"
#include "ui/render/scene/camera.h"
#include "ui/render/scene/palette.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Texture units.
inline constexpr int noise_unit = 0, depth_unit = 1, place_unit = 2, normal_unit = 3,
                     relief_unit = 4;

struct Frame {
  const Scene& scene;
  const EyeView& view;
  DrawTarget target;
  /// Pixels drawn along each side of one shown.
  double pixel_scale = 1.0;
  DoubleMatrix4 clip_from_world{1.0};
  Palette palette;
  /// Direction towards it, world.
  Float3 key_light{0.0F};
  /// The framebuffer of the bones' shapes.
  unsigned shapes = 0;
  unsigned place_texture = 0, normal_texture = 0;
};

Frame frame_of(const Scene& scene, const EyeView& view, const PictureBuffers& buffers,
               double pixel_scale) noexcept;

/// Drawing begins from a state that is said, not from the one that somebody left, and ends with
/// nothing bound, tested or culled.
void begin_drawing(PixelSize size);
void end_drawing();

/// Sets the boxes that part.vert draws.
/// needs   at most boxes_at_most, of a picture of this size
void set_boxes(ShaderProgram& program, std::span<const PixelBox> boxes, PixelSize size);
/// Draws them with the current program, to which they were set.
void draw_boxes(std::span<const PixelBox> boxes);
/// Sets the uniforms of light.glsl.
void set_light(ShaderProgram& program, const Frame& frame);
/// Sets the uniforms of seen_bone.glsl but for its matrices.
void set_seen_bone(ShaderProgram& program, const Frame& frame);
/// Sets the uniforms of ground.glsl.
void set_ground(ShaderProgram& program, const Frame& frame);

}  // namespace hallux::ui
