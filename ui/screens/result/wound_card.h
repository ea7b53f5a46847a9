/// What the saw did beside the cut: heat, dead bone, bend of the blade, danger zones, and force and
/// heat over the strokes. Inside this corner only.
#pragma once

#include <optional>

#include "ui/screens/result/result_material.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Draws the card's content into `rect`, below its title; `moment_s` is marked in the curves.
/// Returns the moment whose link was pressed.
std::optional<double> draw_wound(Ui& ui, const Rect& rect, const WoundFacts& wound,
                                 std::optional<double> moment_s);
/// The height that the content takes at this width.
float wound_height(const Ui& ui, const WoundFacts& wound, float width);

/// That nothing of it is scored, and no surgeon has reviewed it: from the right end of `line` where
/// the title leaves room.
void draw_wound_marks(Ui& ui, const Rect& line);
float wound_marks_width(const Ui& ui);

}  // namespace hallux::ui
