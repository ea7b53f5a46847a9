/// Feeds any bytes to the reader of scenarios, and what can be read to the planner, on coarse
/// bones: each must throw ScenarioError or give a scenario and its plan. Of both formats; the
/// corpus is of format 2.
#include <algorithm>
#include <vector>

#include "scenarios/plan.h"
#include "scenarios/simulation_setup.h"
#include "scenarios/steps/step_order.h"
#include "scenarios/tray/laid_out_tools.h"
#include "simulator/base/check.h"
#include "tests/fuzz/text_fuzz.h"

namespace hallux {

namespace {

constexpr double coarse_edge_mm = 1.5;

std::vector<simulator::Bone> coarse_bones() {
  std::vector<simulator::Bone> made;
  for (const scenarios::FootBone& row : scenarios::foot_bones())
    made.push_back(scenarios::make_foot_bone(row, {.edge_mm = coarse_edge_mm}));
  return made;
}

/// Made before anything is fed: seconds under a sanitizer.
const std::vector<simulator::Bone> coarse = coarse_bones();

/// A bone of its kind for each that the scenario asks for, whatever its sizes.
/// needs   the scenario was read: it names bones of the foot
std::vector<simulator::Bone> patient_of(const scenarios::Scenario& scenario) {
  const auto of_its_kind = [&](const scenarios::PatientRequest& asked) {
    const scenarios::FootBone* const row = scenarios::find_foot_bone(asked.bone);
    CHECK(row != nullptr);
    return coarse[static_cast<std::size_t>(row - scenarios::foot_bones().data())];
  };
  std::vector<simulator::Bone> bones{of_its_kind(scenario.patient)};
  for (const scenarios::PatientRequest& asked : scenario.further_bones)
    bones.push_back(of_its_kind(asked));
  return bones;
}

/// One step at hand after another; the order was checked, so that all come to be done.
void carry_out(const scenarios::Scenario& scenario) {
  std::vector<bool> is_done(scenario.steps.size());
  while (!scenarios::is_all_done(scenario, is_done)) {
    const std::vector<std::size_t> at_hand = scenarios::steps_at_hand(scenario, is_done);
    CHECK(!at_hand.empty());
    for (const std::size_t step : at_hand) is_done[step] = true;
  }
}

void plan_all(const scenarios::Scenario& scenario) {
  const std::vector<simulator::Bone> bones = patient_of(scenario);
  carry_out(scenario);
  CHECK(scenarios::tray_of(scenario).count() ==
        static_cast<std::int32_t>(scenarios::laid_out_tools(scenario).size()));
  const scenarios::Plan plan = scenarios::plan_on(scenario, bones);
  scenarios::simulation_setup(scenario, bones.front(), plan, simulator::Guidance::Slot);
}

}  // namespace

}  // namespace hallux

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace hallux;
  try {
    plan_all(scenarios::parse_scenario(tests::text_of(bytes, size), "fuzz"));
  } catch (const scenarios::ScenarioError&) {
  }
  return 0;
}
