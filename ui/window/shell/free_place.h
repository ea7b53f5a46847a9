/// A place of the window where nothing is that somebody reads or presses. Inside this corner only.
#pragma once

#include <vector>

#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What a message must not cover, of the frame that is seen: controls and texts on the layers that
/// can be reached. A region that scrolls is none, nor is an area that fills most of the display
/// (the view of an operation): what stands in it counts.
struct Obstacles {
  std::vector<Rect> controls, texts;
};
Obstacles obstacles_in(const FrameContent& shown, const Rect& display);

/// How much of the obstacles a rectangle covers; 0: nothing. Controls count for more than texts.
float covered_by(const Rect& rect, const Obstacles& obstacles) noexcept;

/// Where a rectangle of that size covers the least, beginning at the lower right corner; `margin`
/// off the edges of the display.
Rect free_place(const Rect& display, float width, float height, float margin,
                const Obstacles& obstacles);

}  // namespace hallux::ui
