/// Part of a picture: what has to be drawn again of it, or what something can cover.
/// Inside this corner only.
#pragma once

#include <cstddef>

#include "ui/render/gl/render_target.h"
#include "ui/render/scene/box.h"
#include "ui/render/scene/camera.h"

namespace hallux::ui {

/// Counted from the lower left; left and bottom belong to it, right and top do not.
struct PixelBox {
  int left = 0, bottom = 0, right = 0, top = 0;

  bool is_empty() const noexcept { return right <= left || top <= bottom; }
  friend bool operator==(const PixelBox&, const PixelBox&) = default;
};

PixelBox all_of(PixelSize size) noexcept;
std::size_t pixel_count(const PixelBox& box) noexcept;
/// What lies in both.
PixelBox common(const PixelBox& first, const PixelBox& second) noexcept;
/// The smallest that holds both.
PixelBox around(const PixelBox& first, const PixelBox& second) noexcept;

/// The pixels of a picture of this size that a box of a frame can cover: none of an empty one, all
/// where part of it lies beside or behind the eye.
PixelBox pixels_of(const Box& box, const RigidTransform& world_from_frame, const EyeView& view,
                   PixelSize size) noexcept;

/// As many pixels more on each side, within a picture of this size.
PixelBox widened(const PixelBox& box, int pixels, PixelSize size) noexcept;

/// Draws only there.
/// needs   the scissor is on
void set_scissor(const PixelBox& box);

}  // namespace hallux::ui
