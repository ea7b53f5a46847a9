/// The way from a screen to another one. The screens know only this; which screen is there is
/// ui/app's to say, so that no screen needs to know another.
///
/// Each shows its screen over the one that asks; Esc comes back to it.
/// thread  the window's, in a frame; what is asked for happens after it
#pragma once

#include <string>

#include "database/records/attempt.h"
#include "database/records/ids.h"
#include "scenarios/scenario.h"

namespace hallux::ui {

/// How an attempt is begun. Guide and law are chosen for a practice only.
struct WayToOperate {
  database::AttemptKind kind = database::AttemptKind::Practice;
  simulator::Guidance guidance = simulator::Guidance::None;
  /// An arm lets the hand feel the thesis's law where teeth touch bone, for the lesson.
  bool feels_historic_law = false;
};

class Navigator {
 public:
  virtual ~Navigator() = default;

  /// What an operation is about, before it is begun.
  virtual void brief(database::ScenarioVersionId scenario) = 0;
  /// Begins an attempt; the briefing is left for it.
  virtual void operate(database::ScenarioVersionId scenario, const WayToOperate& way) = 0;
  /// The first flight: lessons on a block, of which nothing is kept.
  virtual void fly() = 0;
  /// The score of an attempt with all that led to it.
  virtual void show_result(const database::AttemptId& attempt) = 0;
  /// The attempt again, from a moment on.
  virtual void show_replay(const database::AttemptId& attempt, double moment_s) = 0;
  /// A simulated hand at this operation: made in memory, or as it was made before.
  virtual void watch_expert(const scenarios::Scenario& scenario) = 0;
  /// A trainee as their instructor sees them.
  virtual void show_trainee(database::CohortId cohort, database::PersonId trainee) = 0;
};

}  // namespace hallux::ui
