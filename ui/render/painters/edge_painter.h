/// The pass over a picture in motion that takes the stairs from its edges (shaders/edges.frag).
/// What stands still is smoothed where it changed and kept; what moves over it is smoothed where it
/// is.
#pragma once

#include <span>
#include <vector>

#include "ui/render/gl/gl_objects.h"
#include "ui/render/painters/frame.h"

namespace hallux::ui {

/// What is beyond it cannot change a smoothed pixel.
inline constexpr int edge_reach_pixels = 10;

class EdgePainter {
 public:
  EdgePainter();

  /// Draws the picture of that texture into a target of its size, within the boxes.
  /// ensures nothing is tested, culled or blended afterwards; the target's stencil is 0 there
  void smooth(unsigned colours, const DrawTarget& into, std::span<const PixelBox> boxes);
  /// The same, but only edges that `still` does not have are smoothed: it is smooth.
  void smooth_moving(unsigned colours, unsigned still, const DrawTarget& into,
                     std::span<const PixelBox> boxes);

 private:
  struct Pass {
    unsigned colours = 0;
    const DrawTarget& into;
    std::span<const PixelBox> boxes;
  };

  void begin(const Pass& pass);
  void draw(ShaderProgram& program, const Pass& pass);
  void mark_and_smooth(ShaderProgram& marks, const Pass& pass);

  ShaderProgram copy_, marks_all_, marks_moving_, lines_;
  GlVertexArray no_attributes_;
};

/// The boxes of a picture of this size in which smoothing changes where its pixels changed in
/// `boxes`.
std::vector<PixelBox> within_reach(std::span<const PixelBox> boxes, PixelSize size);

}  // namespace hallux::ui
