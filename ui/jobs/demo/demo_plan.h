/// What happens in the simulated course: who there is, who operates what, when, and how well. Plain
/// data, no store. Inside this corner only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "database/records/attempt.h"
#include "scenarios/hands/hand_skill.h"
#include "scenarios/scenario.h"

namespace hallux::ui {

inline constexpr int demo_trainees = 8;
inline constexpr int demo_instructors = 2;
/// Trainees 1 to 5 are in cohort A, with instructor 2 as a sixth; the others are in cohort B, which
/// instructor 2 teaches.
inline constexpr int demo_trainees_of_first_cohort = 5;

struct DemoAttempt {
  /// 1 to 8.
  int trainee = 1;
  /// Index of those that the course operates.
  std::size_t scenario = 0;
  /// 0 novice, 1 expert.
  double skill = 0.0;
  std::uint64_t seed = 1;
  database::AttemptKind kind = database::AttemptKind::Practice;
  /// Since the course began.
  std::int64_t minute = 0;
  /// Of this trainee, from 0.
  int number = 0;
  /// Of this trainee.
  bool is_last = false;
};

/// In the order in which they happen. Trainees differ in how often they come, where they begin and
/// how fast they get better; the last attempt of those who came at least three times is an
/// assessment.
std::vector<DemoAttempt> plan_demo_attempts(std::size_t scenarios, int attempts_max);

/// How long ago the course began, in minutes: six weeks.
inline constexpr std::int64_t demo_minutes = 42LL * 24 * 60;

/// Every size of error between the novice's and the expert's. `skill` 0 to 1.
scenarios::HandSkill skill_between(double skill);
/// "scripted, skill 0.35"
std::string demo_hand_name(double skill);

}  // namespace hallux::ui
