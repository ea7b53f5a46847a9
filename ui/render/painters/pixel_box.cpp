#include "ui/render/painters/pixel_box.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hallux::ui {

namespace {

/// What rounding may put beside the edge of what is drawn.
constexpr int margin_pixels = 1;

/// The pixels between two shares of a side.
std::array<int, 2> pixels_between(double low, double high, int side) {
  const auto count = static_cast<double>(side);
  const auto pixel = [count](double at) { return static_cast<int>(std::clamp(at, 0.0, count)); };
  return {pixel(std::floor(low * count) - margin_pixels),
          pixel(std::floor(high * count) + 1 + margin_pixels)};
}

Vec3 corner_of(const Box& box, unsigned corner) {
  return Vec3((corner & 1U) != 0 ? box.high_mm.x : box.low_mm.x,
              (corner & 2U) != 0 ? box.high_mm.y : box.low_mm.y,
              (corner & 4U) != 0 ? box.high_mm.z : box.low_mm.z);
}

}  // namespace

PixelBox all_of(PixelSize size) noexcept { return {0, 0, size.width, size.height}; }

std::size_t pixel_count(const PixelBox& box) noexcept {
  if (box.is_empty()) return 0;
  return static_cast<std::size_t>(box.right - box.left) *
         static_cast<std::size_t>(box.top - box.bottom);
}

PixelBox common(const PixelBox& first, const PixelBox& second) noexcept {
  return {std::max(first.left, second.left), std::max(first.bottom, second.bottom),
          std::min(first.right, second.right), std::min(first.top, second.top)};
}

PixelBox around(const PixelBox& first, const PixelBox& second) noexcept {
  if (first.is_empty()) return second;
  if (second.is_empty()) return first;
  return {std::min(first.left, second.left), std::min(first.bottom, second.bottom),
          std::max(first.right, second.right), std::max(first.top, second.top)};
}

PixelBox pixels_of(const Box& box, const RigidTransform& world_from_frame, const EyeView& view,
                   PixelSize size) noexcept {
  if (box.is_empty()) return {};
  Box seen;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 place =
        place_in_picture(view, transform_point(world_from_frame, corner_of(box, corner)));
    if (!(std::abs(place.z) <= 1.0)) return all_of(size);
    seen.add(place);
  }
  const auto [left, right] = pixels_between(seen.low_mm.x, seen.high_mm.x, size.width);
  const auto [bottom, top] = pixels_between(1.0 - seen.high_mm.y, 1.0 - seen.low_mm.y, size.height);
  return {left, bottom, right, top};
}

PixelBox widened(const PixelBox& box, int pixels, PixelSize size) noexcept {
  if (box.is_empty()) return box;
  return common({box.left - pixels, box.bottom - pixels, box.right + pixels, box.top + pixels},
                all_of(size));
}

void set_scissor(const PixelBox& box) {
  glScissor(box.left, box.bottom, std::max(box.right - box.left, 0),
            std::max(box.top - box.bottom, 0));
}

}  // namespace hallux::ui
