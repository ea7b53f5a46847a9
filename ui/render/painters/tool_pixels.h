/// Where of a picture tools are seen, and what they leave. No graphics.
#pragma once

#include "ui/render/painters/pixel_tiles.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// Of the saw, with the swing of a running blade, of drivers, forceps, implants and holes. What
/// reaches beside or behind the eye is left out.
PixelTiles tool_pixels(const Scene& scene, const EyeView& view, PixelSize size);

}  // namespace hallux::ui
