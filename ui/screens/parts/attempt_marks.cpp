#include "ui/screens/parts/attempt_marks.h"

#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/marks.h"

namespace hallux::ui {

std::string_view kind_text(const Ui& ui, const database::AttemptHeader& attempt) {
  if (attempt.begun.kind == database::AttemptKind::Assessment)
    return ui.text("attempts.assessment");
  const bool is_guided = attempt.begun.guidance != simulator::Guidance::None;
  return ui.text(is_guided ? "attempts.guided" : "attempts.practice");
}

std::string_view why_not_counted(const Ui& ui, const database::AttemptHeader& attempt) {
  using database::AttemptState;
  if (attempt.state == AttemptState::Void) return ui.text("uncounted.void");
  if (attempt.state == AttemptState::Interrupted) return ui.text("uncounted.interrupted");
  if (!attempt.is_valid.value_or(true)) return ui.text("uncounted.not_valid");
  if (!attempt.is_counted) return ui.text("uncounted.origin");
  if (attempt.begun.kind == database::AttemptKind::Practice) return ui.text("uncounted.practice");
  return {};
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
  } else if (!attempt.is_valid.value_or(true)) {
    pill(ui, at, ui.text("attempts.not_valid"), Meaning::Warn);
  } else if (!attempt.is_counted) {
    pill(ui, at, ui.text("attempts.not_counted"), Meaning::Neutral, false);
  } else if (attempt.begun.kind == database::AttemptKind::Practice) {
    pill(ui, at, ui.text("attempts.does_not_count"), Meaning::Neutral);
  } else if (attempt.decision && !attempt.decision_is_of_score_in_force) {
    pill(ui, at, ui.text("attempts.signed_before"), Meaning::Warn);
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
