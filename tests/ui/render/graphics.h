/// What tests of the renderer share: a context for each test, and a census of OpenGL's objects.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <functional>
#include <memory>

#include "ui/render/gl/headless_context.h"
#include "ui/render/gl/render_target.h"

namespace hallux::tests {

/// A test with a current context and no window.
class Graphics : public testing::Test {
 protected:
  ui::HeadlessContext context_;
};

/// Objects that live in the current context: buffers, vertex arrays, textures, framebuffers,
/// renderbuffers, programs, shaders. Asks for each of the first names, which OpenGL gives out from
/// below.
struct ObjectCensus {
  std::size_t buffers = 0, vertex_arrays = 0, textures = 0, framebuffers = 0, renderbuffers = 0,
              programs_and_shaders = 0;

  friend bool operator==(const ObjectCensus&, const ObjectCensus&) = default;
};
ObjectCensus count_objects();

/// The error that OpenGL has noted since it was asked last; 0: none.
unsigned take_error();

struct Colour {
  int red = 0, green = 0, blue = 0;
};
/// The pixel, counted from the upper left.
Colour pixel_at(const ui::Pixels& picture, int x, int y);

/// What can be said of the pixels that a rule picks.
struct Facts {
  std::size_t count = 0;
  /// Of all pixels.
  double share = 0.0;
  /// Their mean place in shares of the picture, from the upper left.
  double x = 0.0, y = 0.0;
  /// Their mean colour.
  double red = 0.0, green = 0.0, blue = 0.0;
};
Facts facts_of(const ui::Pixels& picture, const std::function<bool(const Colour&)>& is_picked);

/// Warm and not dark: bone, on either ground.
bool is_bone_coloured(const Colour& colour);

/// Makes one column of a picture opaque white.
void whiten_column(const ui::DrawTarget& target, int column);
/// What is drawn into now, which has that size.
ui::DrawTarget bound_target(ui::PixelSize size);

}  // namespace hallux::tests
