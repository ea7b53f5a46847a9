/// What an attempt was for, its state and its score, as they stand in a row.
#pragma once

#include "database/records/attempt.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Practice, guided (practice with a guide), or assessment.
std::string_view kind_text(const Ui& ui, const database::AttemptHeader& attempt);

/// Why the attempt does not count towards competence, the first reason that there is; "" where it
/// may.
std::string_view why_not_counted(const Ui& ui, const database::AttemptHeader& attempt);

/// A pill from the left of the cell: void, interrupted, recording, not valid, not counted (of an
/// origin that is not accepted), a practice that does not count, signed, or advisory.
void draw_attempt_state(Ui& ui, const database::AttemptHeader& attempt, const Rect& cell);

/// The decided score where there is one, else the machine's, at the right of the cell; words where
/// there is none.
void draw_attempt_score(Ui& ui, const database::AttemptHeader& attempt, const Rect& cell);

}  // namespace hallux::ui
