/// The facts that the panels of an operation show, from its session and its loop.
/// Inside this corner only.
#pragma once

#include "simulator/loop/attempt_watch.h"
#include "ui/jobs/live_attempt.h"
#include "ui/screens/operating/operating_hud.h"
#include "ui/screens/operating/operating_session.h"

namespace hallux::ui {

/// All but the health, the place of the tip on the window, and whether the course is simulated.
/// cut  the planned face that people are shown; nullptr for none
OperatingHud hud_of(const Texts& texts, const OperatingSession& session,
                    const PreparedCase& prepared_case, const simulator::LoopView& loop,
                    const scenarios::PlannedCut* cut);

/// The words about a step that did not come off, as ids of texts.
struct NoticeTexts {
  std::string_view title, detail;
};
NoticeTexts notice_texts(StepNotice notice) noexcept;

}  // namespace hallux::ui
