#include "ui/screens/attempt_marks.h"

#include "ui/screens/words.h"
#include "ui/widgets/marks.h"

namespace hallux::ui {

std::string_view kind_text(const Ui& ui, const database::AttemptHeader& attempt) {
  if (attempt.begun.kind == database::AttemptKind::Assessment)
    return ui.text("attempts.assessment");
  const bool is_guided = attempt.begun.guidance != simulator::Guidance::None;
  return ui.text(is_guided ? "attempts.guided" : "attempts.practice");
}

void draw_attempt_state(Ui& ui, const database::AttemptHeader& attempt, const Rect& cell) {
  const Point at{cell.x, cell.mid_y()};
  using database::AttemptState;
  if (attempt.state == AttemptState::Void) {
    pill(ui, at, ui.text("attempts.void"), Meaning::Neutral, false);
  } else if (attempt.state == AttemptState::Interrupted) {
    pill(ui, at, ui.text("attempts.interrupted"), Meaning::Warn);
  } else if (attempt.state == AttemptState::Recording) {
    pill(ui, at, ui.text("attempts.recording"), Meaning::Info);
  } else if (attempt.decision) {
    pill(ui, at, ui.text("attempts.decided"), Meaning::Good);
  } else {
    pill(ui, at, ui.text("attempts.advisory"), Meaning::Neutral, false);
  }
}

void draw_attempt_score(Ui& ui, const database::AttemptHeader& attempt, const Rect& cell) {
  const Theme& theme = ui.theme();
  if (!attempt.score_milli) {
    ui.canvas().text_in(cell, {Type::Small, theme.text_caption, Align::Right},
                        ui.text("attempts.not_scored"));
    return;
  }
  const std::int64_t milli = attempt.decided_milli.value_or(*attempt.score_milli);
  ui.canvas().text_in(cell, {Type::BodyMedium, theme.text, Align::Right}, points_text(milli));
}

}  // namespace hallux::ui
