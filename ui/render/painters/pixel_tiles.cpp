#include "ui/render/painters/pixel_tiles.h"

#include <algorithm>
#include <array>

namespace hallux::ui {

namespace {

/// llvmpipe shades blocks of this many pixels each way.
constexpr int tile_pixels = 16;
/// Smaller parts take longer to find than they save.
constexpr double part_mm = 3.0;

int tiles_along(int pixels) noexcept { return (pixels + tile_pixels - 1) / tile_pixels; }

int longest_side(const Vec3& size_mm) noexcept {
  const int axis = size_mm.y > size_mm.x ? 1 : 0;
  return size_mm.z > size_mm[axis] ? 2 : axis;
}

std::array<Box, 2> halves_of(const Box& box, int axis) {
  std::array<Box, 2> halves{box, box};
  halves[0].high_mm[axis] = halves[1].low_mm[axis] = 0.5 * (box.low_mm[axis] + box.high_mm[axis]);
  return halves;
}

void add_parts(PixelTiles& tiles, const SeenBox& seen, const Box& box,
               const BallTest& is_asked_for) {
  const Vec3 middle_mm = 0.5 * (box.low_mm + box.high_mm);
  const Vec3 size_mm = box.high_mm - box.low_mm;
  if (!is_asked_for(middle_mm, 0.5 * glm::length(size_mm))) return;
  const int axis = longest_side(size_mm);
  if (size_mm[axis] <= part_mm) {
    const PixelBox pixels = pixels_of(box, seen.world_from_frame, seen.view, seen.size);
    return tiles.add(widened(pixels, seen.margin_pixels, seen.size));
  }
  for (const Box& half : halves_of(box, axis)) add_parts(tiles, seen, half, is_asked_for);
}

}  // namespace

PixelTiles::PixelTiles(PixelSize size)
    : size_(size),
      columns_(tiles_along(size.width)),
      rows_(tiles_along(size.height)),
      is_in_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

void PixelTiles::add(const PixelBox& box) {
  const PixelBox inside = common(box, all_of(size_));
  if (inside.is_empty()) return;
  for (int row = inside.bottom / tile_pixels; row < tiles_along(inside.top); ++row) {
    for (int column = inside.left / tile_pixels; column < tiles_along(inside.right); ++column) {
      is_in_[place_of(column, row)] = true;
    }
  }
}

std::size_t PixelTiles::place_of(int column, int row) const noexcept {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

PixelBox PixelTiles::box_of(int column, int end_column, int row) const noexcept {
  return common(
      {column * tile_pixels, row * tile_pixels, end_column * tile_pixels, (row + 1) * tile_pixels},
      all_of(size_));
}

std::vector<PixelBox> PixelTiles::boxes() const {
  std::vector<PixelBox> boxes;
  PixelBox around_all;
  for (int row = 0; row < rows_; ++row) {
    const auto is_in = [&](int column) {
      return column < columns_ && is_in_[place_of(column, row)];
    };
    for (int column = 0; column < columns_; ++column) {
      if (!is_in(column)) continue;
      const int first = column;
      while (is_in(column)) ++column;
      const PixelBox run = box_of(first, column, row);
      around_all = around(around_all, run);
      // A run below that is as wide goes on upwards.
      const auto below = std::ranges::find_if(boxes, [&](const PixelBox& box) {
        return box.top == run.bottom && box.left == run.left && box.right == run.right;
      });
      if (below != boxes.end()) {
        below->top = run.top;
      } else {
        boxes.push_back(run);
      }
    }
  }
  if (boxes.size() > boxes_at_most) return {around_all};
  return boxes;
}

std::size_t pixel_count(const std::vector<PixelBox>& boxes) noexcept {
  std::size_t count = 0;
  for (const PixelBox& box : boxes) count += pixel_count(box);
  return count;
}

void add_parts(PixelTiles& tiles, const SeenBox& seen, const BallTest& is_asked_for) {
  if (!seen.box.is_empty()) add_parts(tiles, seen, seen.box, is_asked_for);
}

}  // namespace hallux::ui
