/// The picture of a blade's plane: for an inset beside the main picture.
#pragma once

#include <span>

#include "ui/screens/pictures/blade_section.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Draws it: bone, canal, what is open, the blade, the way that lies ahead in picture and words,
/// the plan's limits, danger zones. The saw goes downwards.
void draw_blade_section(Ui& ui, const Rect& rect, const BladeSection& section);

/// The same before anything is sawn: a numbered blade before the bone for each pass, and where its
/// edges run through the section.
/// middles_mm  of the passes, along y
void draw_section_with_passes(Ui& ui, const Rect& rect, const BladeSection& section,
                              std::span<const double> middles_mm, double blade_width_mm);

}  // namespace hallux::ui
