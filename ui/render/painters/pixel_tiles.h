/// Parts of a picture that no one box holds well, as square tiles: a line across a bone, the rim of
/// a shadow. No graphics. Inside this corner only.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "ui/render/painters/pixel_box.h"

namespace hallux::ui {

/// As many as shaders/part.vert takes.
inline constexpr std::size_t boxes_at_most = 128;

class PixelTiles {
 public:
  /// None of a picture of this size.
  explicit PixelTiles(PixelSize size = {});

  /// Every tile that the box touches.
  void add(const PixelBox& box);
  /// The tiles as boxes that do not overlap, at most boxes_at_most: where that is not enough, one
  /// around all.
  std::vector<PixelBox> boxes() const;

 private:
  std::size_t place_of(int column, int row) const noexcept;
  PixelBox box_of(int column, int end_column, int row) const noexcept;

  PixelSize size_{};
  int columns_ = 0, rows_ = 0;
  /// One for each tile, rows from the bottom.
  std::vector<bool> is_in_;
};

std::size_t pixel_count(const std::vector<PixelBox>& boxes) noexcept;

/// Whether something is in a ball of a frame.
using BallTest = std::function<bool(const Vec3& middle_mm, double radius_mm)>;

/// A box of a frame in a view.
struct SeenBox {
  Box box;
  RigidTransform world_from_frame;
  const EyeView& view;
  PixelSize size;
  /// More on each side.
  int margin_pixels = 0;
};

/// Adds the pixels of those parts of the box that are asked for: it is halved some times, and a
/// part counts where the ball around it does.
void add_parts(PixelTiles& tiles, const SeenBox& seen, const BallTest& is_asked_for);

}  // namespace hallux::ui
