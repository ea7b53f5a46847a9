/// A camera as what was on the screen, and back: for whoever keeps it and whoever shows it again.
/// Inside this room's screens only.
#pragma once

#include "simulator/record/display_fact.h"
#include "ui/render/scene/camera.h"

namespace hallux::ui {

/// `width_over_height` is the picture's; stereo and layout are the caller's to say.
simulator::ShownView shown_view(const Camera& camera, double width_over_height) noexcept;

/// Shows all that was seen then in a picture of that shape: in a wider one as much from top to
/// bottom, in a higher one as much across.
Camera camera_of(const simulator::ShownView& view, double width_over_height) noexcept;

}  // namespace hallux::ui
