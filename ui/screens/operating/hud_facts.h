/// The facts that the panels of an operation show, from its session, its loop and its site.
///
/// In practice all that is known is told. In an assessment it is what a surgeon would have: the
/// saw, the push, whether the teeth are on bone, and why a button is off, in plain words.
#pragma once

#include "simulator/loop/attempt_watch.h"
#include "ui/jobs/live_attempt.h"
#include "ui/screens/operating/coach.h"
#include "ui/screens/operating/hud/operating_hud.h"
#include "ui/screens/operating/operating_session.h"
#include "ui/screens/operating/site/site_survey.h"

namespace hallux::ui {

/// What there is to tell from; all borrowed.
struct HudSources {
  const Texts& texts;
  const OperatingSession& session;
  const PreparedCase& prepared_case;
  /// By the plan's cuts.
  const std::vector<scenarios::PlannedPasses>& passes;
  const simulator::LoopView& loop;
  /// Null before it is known, and after a hinge was closed.
  const SiteFacts* site = nullptr;
  /// The planned face at hand, whether or not it is drawn; null where people are to know none.
  const scenarios::PlannedCut* cut = nullptr;
  /// Axes of the person's view: x right, y up, z to the person.
  Quat world_from_view{1.0, 0.0, 0.0, 0.0};
};

/// What the coach looks at; borrows what `from` borrows.
CoachView coach_view(const HudSources& from);
/// At other steps than the session's; borrows them too.
CoachView coach_view(const HudSources& from, const StepProgress& steps);

/// All but the health, the places on the window, the hand, the inset, and whether the course is
/// simulated.
/// is_hinted  the next thing to do is told
OperatingHud hud_of(const HudSources& from, bool is_hinted);

/// "Still held: 15 % of the section, plantar-distal."
std::string held_text(const Texts& texts, const scenarios::HeldCut& held);

/// The words about what did not come off, as ids of texts.
struct NoticeTexts {
  std::string_view title, detail;
};
NoticeTexts notice_texts(Notice notice) noexcept;

}  // namespace hallux::ui
