#include "ui/jobs/publish_scenario.h"

#include <algorithm>
#include <vector>

#include "scenarios/scenario_error.h"
#include "ui/jobs/prove_scenario.h"

namespace hallux::ui {

namespace {

/// Of each performance: the bone is built, the hand operates, the score is made.
constexpr double stages_of_performance = 3.0;
/// More would fill the window; the command tells them all.
constexpr std::size_t told_most = 3;

/// "tilt:proximal_face=8: A1 loses 1 of 16 rubric points, less than half."
std::vector<std::string> differences_of(const ScenarioProof& proof) {
  std::vector<std::string> all;
  const auto add = [&](const ProvedPerformance& performance) {
    for (const std::string& difference : performance.differences)
      all.push_back(performance.name + ": " + difference);
  };
  add(proof.perfect);
  std::ranges::for_each(proof.faults, add);
  return all;
}

[[noreturn]] void refuse(const scenarios::Scenario& scenario, const ScenarioProof& proof) {
  const std::vector<std::string> differences = differences_of(proof);
  std::string sentence =
      "the rubric of " + scenario.title + ", version " + std::to_string(scenario.version) +
      ", does not tell a good performance from a bad one, so it is not published.";
  for (std::size_t i = 0; i < std::min(told_most, differences.size()); ++i)
    sentence += "\n" + differences[i];
  if (differences.size() > told_most)
    sentence += "\n" + std::to_string(differences.size() - told_most) + " more.";
  throw scenarios::ScenarioError(
      sentence +
      "\nMend its knots or its field `proof`; `hallux scenario prove FILE` tells all of it.");
}

}  // namespace

void prove_to_publish(const scenarios::Scenario& scenario, const Progress& progress) {
  const double stages = stages_of_performance * static_cast<double>(1 + scenario.proof.size());
  double begun = 0.0;
  const StageProgress stage = [&](const std::string&) {
    const double done = begun / stages;
    begun = std::min(begun + 1.0, stages);
    return part_of(progress, done, begun / stages);
  };
  const ScenarioProof proof = prove_scenario(scenario, stage);
  if (!proof.has_passed()) refuse(scenario, proof);
}

}  // namespace hallux::ui
