/// Draws on what is seen of bones: where planes meet them, and where the teeth do.
#pragma once

#include <map>
#include <vector>

#include "ui/render/gl/gl_objects.h"
#include "ui/render/painters/frame.h"

namespace hallux::ui {

class SurfacePainter {
 public:
  SurfacePainter();

  /// The scene's lines and those of its planes, over the lit skins of bones that are wholly
  /// present.
  /// needs   the shapes of all the picture are drawn; a framebuffer with their stencil is bound
  void draw_lines(const Frame& frame);
  /// needs   as for lines
  void draw_halo(const Frame& frame);

 private:
  ShaderProgram& lines_program(std::size_t count);

  /// By how many lines, made when first needed.
  std::map<std::size_t, ShaderProgram> lines_;
  ShaderProgram halo_;
  GlVertexArray no_attributes_;
};

}  // namespace hallux::ui
