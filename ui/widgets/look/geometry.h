/// Points and rectangles of the window, in logical pixels: px at content scale 1, from the top left
/// corner.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hallux::ui {

struct Point {
  float x = 0.0F, y = 0.0F;

  friend bool operator==(const Point&, const Point&) = default;
};

struct Rect {
  float x = 0.0F, y = 0.0F, w = 0.0F, h = 0.0F;

  float right() const noexcept { return x + w; }
  float bottom() const noexcept { return y + h; }
  float mid_x() const noexcept { return x + w / 2.0F; }
  float mid_y() const noexcept { return y + h / 2.0F; }
  Point centre() const noexcept { return {mid_x(), mid_y()}; }
  bool is_empty() const noexcept { return w <= 0.0F || h <= 0.0F; }
  bool contains(Point point) const noexcept {
    return point.x >= x && point.x < right() && point.y >= y && point.y < bottom();
  }
  /// True where `inner` lies in this one, up to `slack` on each side.
  bool encloses(const Rect& inner, float slack = 0.0F) const noexcept {
    return inner.x >= x - slack && inner.y >= y - slack && inner.right() <= right() + slack &&
           inner.bottom() <= bottom() + slack;
  }

  friend bool operator==(const Rect&, const Rect&) = default;
};

/// `rect` made smaller by `across` at the left and right and by `down` at the top and bottom;
/// negative grows it.
constexpr Rect inset(const Rect& rect, float across, float down) noexcept {
  return {rect.x + across, rect.y + down, rect.w - 2.0F * across, rect.h - 2.0F * down};
}
constexpr Rect inset(const Rect& rect, float by) noexcept { return inset(rect, by, by); }

constexpr Rect moved(const Rect& rect, float dx, float dy) noexcept {
  return {rect.x + dx, rect.y + dy, rect.w, rect.h};
}

/// What two rectangles share; empty (w or h 0) where they share nothing.
inline Rect intersection(const Rect& a, const Rect& b) noexcept {
  const float x = std::max(a.x, b.x), y = std::max(a.y, b.y);
  return {x, y, std::max(0.0F, std::min(a.right(), b.right()) - x),
          std::max(0.0F, std::min(a.bottom(), b.bottom()) - y)};
}

/// Cuts a strip off one side of `rest` and leaves `gap` between; a strip longer than `rest` takes
/// all of it.
inline Rect take_top(Rect& rest, float height, float gap = 0.0F) noexcept {
  const Rect strip{rest.x, rest.y, rest.w, std::min(height, rest.h)};
  const float used = std::min(rest.h, height + gap);
  rest.y += used;
  rest.h -= used;
  return strip;
}
inline Rect take_bottom(Rect& rest, float height, float gap = 0.0F) noexcept {
  const float own = std::min(height, rest.h);
  const Rect strip{rest.x, rest.bottom() - own, rest.w, own};
  rest.h -= std::min(rest.h, height + gap);
  return strip;
}
inline Rect take_left(Rect& rest, float width, float gap = 0.0F) noexcept {
  const Rect strip{rest.x, rest.y, std::min(width, rest.w), rest.h};
  const float used = std::min(rest.w, width + gap);
  rest.x += used;
  rest.w -= used;
  return strip;
}
inline Rect take_right(Rect& rest, float width, float gap = 0.0F) noexcept {
  const float own = std::min(width, rest.w);
  const Rect strip{rest.right() - own, rest.y, own, rest.h};
  rest.w -= std::min(rest.w, width + gap);
  return strip;
}

/// `count` columns of equal width with `gap` between them.
inline std::vector<Rect> columns(const Rect& rect, int count, float gap) {
  const auto number = static_cast<float>(std::max(count, 1));
  const float width = (rect.w - gap * (number - 1.0F)) / number;
  std::vector<Rect> result = {};
  result.reserve(static_cast<std::size_t>(std::max(count, 0)));
  for (int column = 0; column < count; ++column)
    result.push_back({rect.x + static_cast<float>(column) * (width + gap), rect.y, width, rect.h});
  return result;
}

/// A rectangle of this size in the middle of `rect`.
constexpr Rect centred(const Rect& rect, float width, float height) noexcept {
  return {rect.x + (rect.w - width) / 2.0F, rect.y + (rect.h - height) / 2.0F, width, height};
}

}  // namespace hallux::ui
