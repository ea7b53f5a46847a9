/// How an attempt was recorded, and what an arm made of its force: for those who decide about the
/// result. Inside this corner only.
#pragma once

#include "ui/screens/result/result_material.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

void draw_recording_card(Ui& ui, const Rect& rect, const ResultFacts& facts);
float recording_card_height(const Ui& ui, const ResultFacts& facts, float width);

}  // namespace hallux::ui
