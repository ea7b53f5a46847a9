/// A course in which the shipped Akin is published beside a text that this program cannot read, and
/// scored attempts at it.
#pragma once

#include "database/content/assets.h"
#include "scenarios/scenario.h"
#include "tests/database/some_course.h"

namespace hallux::ui {

class SomePublished {
 public:
  SomePublished() : scenario_(scenarios::load_shipped_scenario("akin")) {
    database::AdministratorDesk desk = course_.administrator();
    akin_ = desk.import_scenario({"akin", 1, scenario_.text, false});
    desk.publish_scenario(akin_);
  }

  database::SomeCourse& course() noexcept { return course_; }
  database::ScenarioVersionId akin() const noexcept { return akin_; }

  /// An attempt at the Akin, not scored.
  database::AttemptId attempted_by(const std::string& login, database::AttemptKind kind,
                                   simulator::Guidance guidance = simulator::Guidance::None) {
    database::NewAttempt attempt = course_.attempt_of(login);
    attempt.scenario = akin_;
    attempt.kind = kind;
    attempt.guidance = guidance;
    return database::record(course_.database(), attempt, database::some_recording(5));
  }
  database::AttemptId scored_by(const std::string& login, std::int64_t score_milli,
                                database::AttemptKind kind = database::AttemptKind::Practice,
                                bool is_gated = false) {
    database::AttemptId id = attempted_by(login, kind);
    database::ScoreCard card = database::card_worth(score_milli);
    card.rubric_version = scenario_.rubric.version;
    if (is_gated) card.gates.emplace_back().is_triggered = true;
    database::store_score(course_.database(), id, card, course_.id_of(login));
    return id;
  }
  /// Assessments in a row, all of this worth.
  void assessed(const std::string& login, int count, std::int64_t score_milli) {
    for (int number = 0; number < count; ++number) {
      scored_by(login, score_milli, database::AttemptKind::Assessment);
    }
  }

 private:
  database::SomeCourse course_;
  scenarios::Scenario scenario_;
  database::ScenarioVersionId akin_;
};

}  // namespace hallux::ui
