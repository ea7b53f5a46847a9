// What it takes to score an attempt of ten minutes from its poses, how much of that are the
// metrics, and what one change costs of what another performance would have earned.
//
// The ten minutes are one performance: the expert's hand with the fault *slow*, so that everything
// takes as many times as long. It stands longer in each place than a slow person would.
#include <algorithm>
#include <exception>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "assessment/process/followed_effects.h"
#include "assessment/what_if.h"
#include "scenarios/plan.h"
#include "scenarios/scenario.h"
#include "tests/benchmarks/report/percentiles.h"
#include "tests/benchmarks/report/table.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::benchmarks {

namespace {

using assessment::Change;
using assessment::Examination;
using assessment::WhatIf;

constexpr std::uint64_t seed = 3;

struct Attempt {
  Attempt(const std::string& name, double edge_mm, const std::vector<std::string>& faults)
      : scenario(scenarios::load_shipped_scenario(name)) {
    if (edge_mm > 0.0) scenario.patient.edge_mm = edge_mm;
    bone = make_patient_bones(scenario).front();
    plan = plan_on(scenario, bone);
    const scenarios::HandSkill skill =
        with_faults(scenarios::hand_skill("expert"), parse_hand_faults(faults, scenario));
    scenarios::FeelingHand hand(scenario, bone, plan, skill, seed);
    recording = tests::run_hand(scenario, bone, plan, hand).recording;
  }
  Examination examined() const {
    return assessment::assess_fully(scenario, bone, recording, "scripted");
  }
  double minutes() const { return static_cast<double>(recording.samples.size()) / 60000.0; }
  std::size_t triangles() const { return solid_of(bone).triangles.size(); }

  scenarios::Scenario scenario;
  simulator::Bone bone;
  scenarios::Plan plan;
  simulator::Recording recording;
};

void add_row(Table& table, const std::string& what, const Percentiles& spread,
             std::optional<double> goal_ms = std::nullopt) {
  Cell goal;
  if (goal_ms) goal = *goal_ms;
  table.rows.push_back({what, static_cast<double>(spread.count), spread.median, spread.p99, goal});
}

Table empty_table(std::string name, std::string title) {
  return {.name = std::move(name),
          .title = std::move(title),
          .columns = {"what", "times", "median ms", "p99 ms", "goal ms"},
          .rows = {},
          .notes = {"a million square roots in a row take " + text_of(calibration_ms()) +
                    " ms here; processor time"}};
}

/// Rebuilt, with heat and zones followed on the way.
assessment::RebuiltBone followed(const Attempt& attempt) {
  assessment::FollowedEffects effects(attempt.bone, attempt.scenario.saw, attempt.plan);
  return assessment::rebuild(
      attempt.bone, attempt.scenario.saw.blade, attempt.recording, {}, nullptr,
      [&](const simulator::ToolSample& sample, const simulator::KerfSet& kerfs) {
        effects.follow(sample, kerfs);
      });
}

/// The processor time of one way to do the work, which leaves that many pieces.
template <typename Work>
double worked_ms(std::size_t pieces, Work&& work) {
  const Stopwatch watch;
  const auto made = work();
  const double ms = watch.worked_milliseconds();
  if (made.pieces.size() != pieces) throw std::runtime_error("two rebuilds left different pieces");
  return ms;
}

void add_shares(Table& table, const char* what, const std::vector<double>& more_ms,
                const std::vector<double>& than_ms) {
  std::vector<double> shares;
  for (std::size_t run = 0; run < more_ms.size(); ++run)
    shares.push_back(100.0 * (more_ms[run] / than_ms[run] - 1.0));
  const Percentiles share = percentiles_of(shares);
  table.notes.push_back(std::string(what) + " adds " + text_of(share.median) +
                        " % in the median, " + text_of(share.greatest) + " % at most");
}

/// Side by side, in turn: their ratios are of one machine in one state.
Table scoring_table(const std::string& name, const std::string& slow) {
  const Attempt attempt(name, 0.0, {slow});
  const auto& blade = attempt.scenario.saw.blade;
  Table table = empty_table("scoring_" + name, "An expert's " + name + ", slowed to " +
                                                   text_of(attempt.minutes()) +
                                                   " minutes, scored from its poses");
  const std::size_t pieces = attempt.examined().rebuilt.pieces.size();
  std::vector<double> rebuilt_ms, followed_ms, whole_ms;
  for (int run = 0; run < 5; ++run) {
    rebuilt_ms.push_back(worked_ms(
        pieces, [&] { return assessment::rebuild(attempt.bone, blade, attempt.recording); }));
    followed_ms.push_back(worked_ms(pieces, [&] { return followed(attempt); }));
    whole_ms.push_back(worked_ms(pieces, [&] { return attempt.examined().rebuilt; }));
  }
  add_row(table, "the bone rebuilt", percentiles_of(rebuilt_ms));
  add_row(table, "rebuilt, heat and danger zones followed", percentiles_of(followed_ms));
  add_row(table, "the whole: followed, measured, scored", percentiles_of(whole_ms), 8000.0);
  add_shares(table, "to the rebuild, following", followed_ms, rebuilt_ms);
  add_shares(table, "to what is followed, measuring (goal 20 %)", whole_ms, followed_ms);
  return table;
}

/// Of a bone with about 100,000 triangles.
Table what_if_table(const std::string& name) {
  const Attempt attempt(name, 0.32, {});
  const WhatIf what_if(attempt.scenario, attempt.bone, attempt.recording, "scripted",
                       attempt.examined());
  Table table =
      empty_table("what_if_" + name, "One change of an expert's " + name + " on " +
                                         std::to_string(attempt.triangles()) + " triangles");
  for (const assessment::KnownChange& known : what_if.known()) {
    if (known.is_replaced) continue;
    const std::vector<Change> change{{known.name, known.from + 0.5}};
    add_row(table, known.name,
            time_ms(
                {.least = 7, .most = 15, .limit_s = 4.0}, [] { return 0; },
                [&](int) { return what_if.with(change); }),
            300.0);
  }
  return table;
}

}  // namespace

}  // namespace hallux::benchmarks

int main(int count, char** words) {
  using namespace hallux::benchmarks;
  try {
    const std::vector<std::string> names(words + 1, words + count);
    const auto is_asked = [&](const char* name) {
      return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    if (is_asked("silver")) print_table(std::cout, scoring_table("silver", "slow=4"));
    if (is_asked("akin")) print_table(std::cout, scoring_table("akin", "slow=3.2"));
    if (!is_asked("what-if")) return 0;
    for (const char* name : {"silver", "akin"}) print_table(std::cout, what_if_table(name));
  } catch (const std::exception& error) {
    std::cerr << "assessment_table: " << error.what()
              << "\nusage: assessment_table [silver] [akin] [what-if]\n";
    return 2;
  }
  return 0;
}
