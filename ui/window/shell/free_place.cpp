#include "ui/window/shell/free_place.h"

#include <algorithm>

namespace hallux::ui {

namespace {

constexpr float ground_share = 0.4F, step = 12.0F, breathing = 4.0F, control_weight = 100.0F;

float shared_area(const Rect& a, const Rect& b) noexcept {
  const Rect both = intersection(a, b);
  return both.w * both.h;
}

bool is_ground(const Widget& widget, const Rect& display) noexcept {
  return widget.role == Role::Area &&
         widget.visible.w * widget.visible.h > ground_share * display.w * display.h;
}

}  // namespace

Obstacles obstacles_in(const FrameContent& shown, const Rect& display) {
  Obstacles found;
  const Layer lowest = reachable_layer(shown);
  for (const Widget& widget : shown.widgets) {
    const bool counts = widget.layer >= lowest && widget.layer < Layer::Toast &&
                        widget.role != Role::Scroll && !widget.visible.is_empty() &&
                        !is_ground(widget, display) &&
                        !(widget.visible.w >= display.w && widget.visible.h >= display.h);
    if (counts) found.controls.push_back(widget.visible);
  }
  for (const SeenText& seen : shown.texts)
    if (seen.layer >= lowest && seen.layer < Layer::Toast && !seen.gives_way)
      found.texts.push_back(seen.visible);
  return found;
}

float covered_by(const Rect& rect, const Obstacles& obstacles) noexcept {
  const Rect reach = inset(rect, -breathing);
  float covered = 0.0F;
  for (const Rect& control : obstacles.controls)
    covered += control_weight * shared_area(reach, control);
  for (const Rect& text : obstacles.texts) covered += shared_area(reach, text);
  return covered;
}

Rect free_place(const Rect& display, float width, float height, float margin,
                const Obstacles& obstacles) {
  const float right = display.right() - margin - width, left = display.x + margin;
  Rect best{std::max(left, right), std::max(margin, display.bottom() - margin - height), width,
            height};
  float least = covered_by(best, obstacles);
  for (const float x : {right, left, display.mid_x() - width / 2.0F}) {
    for (float y = display.bottom() - margin - height; y >= display.y + margin; y -= step) {
      if (least <= 0.0F) return best;
      const Rect tried{std::max(x, 0.0F), y, width, height};
      const float covered = covered_by(tried, obstacles);
      if (covered < least) least = covered, best = tried;
    }
  }
  return best;
}

}  // namespace hallux::ui
