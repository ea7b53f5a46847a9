/// What the saw did beside the cut: heat, dead bone, bend of the blade, danger zones, and force and
/// heat over the strokes. Inside this corner only.
#pragma once

#include <optional>

#include "ui/screens/result/result_material.h"
#include "ui/widgets/controls/timeline_view.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Draws the card's content into `rect`, below its title; `moment_s` is marked in the curves.
/// Returns the moment whose link or mark was pressed.
std::optional<double> draw_effects(Ui& ui, const Rect& rect, const EffectFacts& effects,
                                   std::optional<double> moment_s, TimelineState& state);
/// The height that the content takes at this width.
float effects_height(const Ui& ui, const EffectFacts& effects, float width,
                     const TimelineState& state);

/// That no surgeon has reviewed it, and that nothing of it is scored where that is so: from the
/// right end of `line` where the title leaves room.
void draw_effects_marks(Ui& ui, const Rect& line, bool is_scored);
float effects_marks_width(const Ui& ui, bool is_scored);

}  // namespace hallux::ui
