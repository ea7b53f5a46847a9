// Both hands with many seeds at both operations, on bones that are sawn in a moment: each finds its
// cuts, saws, and comes to an end of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "scenarios/plan.h"
#include "scenarios/scenario_error.h"
#include "tests/scenarios/hands/scripted_attempt.h"

namespace hallux::tests {
namespace {

#ifdef HALLUX_LONG_RUNS
constexpr std::size_t seeds = 200, hands_of_seed = 2;
#else
// The hands take turns.
constexpr std::size_t seeds = 10, hands_of_seed = 1;
#endif
constexpr std::array hands{"expert", "novice"};

/// One of all performances.
struct Performance {
  const char* hand = nullptr;
  std::uint64_t seed = 0;
};

Performance performance(std::size_t index) {
  return {hands[index % hands.size()], index / hands_of_seed + 1};
}

constexpr double coarse_mm = 1.5;

bool is_told(const simulator::Recording& recording, simulator::CutEventKind kind) {
  return std::ranges::any_of(recording.events,
                             [&](const simulator::CutEvent& event) { return event.kind == kind; });
}

/// Why a hand did not operate; empty where it did.
std::string fault_of(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                     const Performance& by) {
  try {
    const simulator::Recording recording = run_hand(scenario, bone, by.hand, by.seed).recording;
    const bool has_sawn = std::ranges::any_of(recording.samples, [](const auto& sample) {
      return has(sample.status, simulator::ToolStatus::Cutting);
    });
    if (!has_sawn) return "did not saw";
    if (!is_told(recording, simulator::CutEventKind::StepDone)) return "did no step";
    const bool has_ended = is_told(recording, simulator::CutEventKind::Finished);
    return has_ended ? "" : "was still at work when its time was over";
  } catch (const scenarios::ScenarioError& error) {
    return error.what();
  }
}

void expect_that_every_seed_operates(const char* operation) {
  scenarios::Scenario scenario = scenarios::load_shipped_scenario(operation);
  scenario.patient.edge_mm = coarse_mm;
  const simulator::Bone bone = make_patient_bones(scenario).front();
  std::array<std::string, hands_of_seed * seeds> faults;
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    for (std::size_t index = next++; index < faults.size(); index = next++)
      faults[index] = fault_of(scenario, bone, performance(index));
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(2U, std::thread::hardware_concurrency()); ++i)
      threads.emplace_back(work);
  }
  for (std::size_t index = 0; index < faults.size(); ++index)
    EXPECT_EQ(faults[index], "") << performance(index).hand << ", seed " << performance(index).seed;
}

TEST(EverySeed, OperatesSilver) { expect_that_every_seed_operates("silver"); }

TEST(EverySeed, OperatesAkin) { expect_that_every_seed_operates("akin"); }

}  // namespace
}  // namespace hallux::tests
