/// A device that is felt, drawn: where its grip is in its reach, its buttons, how fast it answers.
/// Inside this corner only.
#pragma once

#include "ui/jobs/devices/felt_device.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

inline constexpr float felt_view_height = 196.0F;

/// needs   it runs
void draw_felt_view(Ui& ui, const Rect& rect, const FeltState& felt,
                    const simulator::PortFigures& figures);

}  // namespace hallux::ui
