/// Where of a picture the saw is seen. No graphics.
#pragma once

#include "ui/render/painters/pixel_tiles.h"
#include "ui/render/scene/scene.h"

namespace hallux::ui {

/// With the swing of a running blade. What reaches beside or behind the eye is left out.
PixelTiles saw_pixels(const SawInScene& saw, const EyeView& view, PixelSize size);

}  // namespace hallux::ui
