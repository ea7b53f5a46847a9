#include "ui/jobs/demo/demo_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simulator/base/random.h"

namespace hallux::ui {

namespace {

constexpr std::uint64_t demo_seed = 20'260'301;
constexpr std::int64_t minutes_of_day = 24 * 60;

/// How often each trainee comes; the first came to show a curve, the last has only just begun.
constexpr std::array<int, demo_trainees> visits{6, 5, 4, 3, 3, 2, 2, 1};
/// How well they do at first: some have done it before, some get nowhere.
constexpr std::array<double, demo_trainees> beginnings{0.1, 0.5, 0.3, 0.0, 0.7, 0.4, 0.2, 0.6};

double between(double novice, double expert, double skill) {
  return novice + (expert - novice) * skill;
}

}  // namespace

std::vector<DemoAttempt> plan_demo_attempts(std::size_t scenarios, int attempts_max) {
  std::vector<DemoAttempt> attempts;
  for (int trainee = 1; trainee <= demo_trainees; ++trainee) {
    Random random{demo_seed, "trainee " + std::to_string(trainee)};
    const double beginning = beginnings[static_cast<std::size_t>(trainee - 1)];
    const double gain = random.uniform(0.08, 0.2);
    const int count = std::min(visits[static_cast<std::size_t>(trainee - 1)], attempts_max);
    for (int number = 0; number < count; ++number) {
      DemoAttempt attempt;
      attempt.trainee = trainee;
      attempt.number = number;
      // The first operation is learned first; from the third visit on they take turns.
      const auto turn = static_cast<std::size_t>(number < 2 ? 0 : number - 1);
      attempt.scenario = turn % scenarios;
      attempt.skill = std::clamp(beginning + gain * number, 0.0, 1.0);
      attempt.seed = 100 * static_cast<std::uint64_t>(trainee) + static_cast<std::uint64_t>(number);
      attempt.is_last = number + 1 == count;
      if (attempt.is_last && count >= 3) attempt.kind = database::AttemptKind::Assessment;
      const auto day = static_cast<std::int64_t>(1 + 6 * number + random.uniform(0.0, 5.0));
      const auto minute_of_day = static_cast<std::int64_t>(random.uniform(8.0 * 60, 17.0 * 60));
      attempt.minute = day * minutes_of_day + minute_of_day;
      attempts.push_back(attempt);
    }
  }
  std::sort(attempts.begin(), attempts.end(),
            [](const DemoAttempt& a, const DemoAttempt& b) { return a.minute < b.minute; });
  return attempts;
}

scenarios::HandSkill skill_between(double skill) {
  const scenarios::HandSkill novice = scenarios::hand_skill("novice");
  const scenarios::HandSkill expert = scenarios::hand_skill("expert");
  const auto mixed = [&](double scenarios::HandSkill::*size) {
    return between(novice.*size, expert.*size, skill);
  };
  const auto mixed_into = [&](auto& part, auto scenarios::HandSkill::*whole, auto... sizes) {
    ((part.*sizes = between(novice.*whole.*sizes, expert.*whole.*sizes, skill)), ...);
  };
  using scenarios::Cooling, scenarios::Perception, scenarios::Push;
  scenarios::HandSkill hand;
  for (const auto size :
       {&scenarios::HandSkill::angle_mean_deg, &scenarios::HandSkill::angle_deviation_deg,
        &scenarios::HandSkill::location_mean_mm, &scenarios::HandSkill::location_deviation_mm,
        &scenarios::HandSkill::wander_mm, &scenarios::HandSkill::wander_rad,
        &scenarios::HandSkill::stroke_jitter_mm, &scenarios::HandSkill::stroke_jitter_rad,
        &scenarios::HandSkill::edge_margin_mm, &scenarios::HandSkill::approach_mm_s,
        &scenarios::HandSkill::stop_mean_mm, &scenarios::HandSkill::stop_deviation_mm,
        &scenarios::HandSkill::meet_deviation_mm, &scenarios::HandSkill::shift_deviation_mm,
        &scenarios::HandSkill::shift_turn_deviation_deg}) {
    hand.*size = mixed(size);
  }
  mixed_into(hand.push, &scenarios::HandSkill::push, &Push::steady_newton, &Push::exit_newton,
             &Push::exit_mm, &Push::most_newton_per_mm, &Push::unevenness,
             &Push::impatience_newton_per_s, &Push::brace_newton_s_per_mm, &Push::lean_mm_s);
  mixed_into(hand.perception, &scenarios::HandSkill::perception, &Perception::reaction_s,
             &Perception::eye_mm, &Perception::doubt_mm_per_s, &Perception::look_s,
             &Perception::steadying_per_s);
  mixed_into(hand.cooling, &scenarios::HandSkill::cooling, &Cooling::forgets_water,
             &Cooling::notices_dry_s, &Cooling::burst_s, &Cooling::clear_mm);
  return hand;
}

std::string demo_hand_name(double skill) {
  const long hundredths = std::lround(100.0 * skill);
  const std::string digits = std::to_string(hundredths % 100);
  return "scripted, skill " + std::to_string(hundredths / 100) + "." +
         (digits.size() < 2 ? "0" : "") + digits;
}

}  // namespace hallux::ui
