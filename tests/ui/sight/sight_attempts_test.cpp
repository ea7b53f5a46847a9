// What is seen over the recordings of the expert's hand, from where each operation begins.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/scenarios/hands/scripted_attempt.h"
#include "tests/ui/sight/recorded_moments.h"
#include "ui/render/gl/headless_context.h"
#include "ui/sight/start_place.h"
#include "ui/sight/view_judge.h"

namespace hallux::ui {
namespace {

class ExpertSeen : public testing::TestWithParam<const char*> {};

TEST_P(ExpertSeen, ShowsFourFifthsOfTeethAndKerf) {
  const scenarios::Scenario scenario = scenarios::load_shipped_scenario(GetParam());
  const simulator::Bone bone = make_patient_bones(scenario).front();
  const scenarios::Plan plan = plan_on(scenario, bone);
  const HeadlessContext context;
  ViewJudge judge(scenario, bone, plan);
  const Camera camera = start_camera(scenario, bone, plan);
  // An attempt of Silver with seed 3 never frees the eminence: it shows no operation that was done.
  for (const std::uint64_t seed : {1U, 2U, 4U}) {
    const simulator::Recording recording =
        tests::run_hand(scenario, bone, "expert", seed).recording;
    const std::vector<WorkMoment> moments =
        moments_of(recording, scenario.saw.blade, bone.world_from_bone, 500);
    ASSERT_GT(moments.size(), 20U);
    const Visibility seen = judge.seen_over(camera, moments).mean;
    std::printf("%s, seed %d: teeth %.3f, kerf %.3f over %zu moments\n", GetParam(),
                static_cast<int>(seed), seen.tooth_line_share, seen.kerf_share, moments.size());
    EXPECT_GE(seen.tooth_line_share, 0.80) << seed;
    EXPECT_GE(seen.kerf_share, 0.80) << seed;
  }
}

INSTANTIATE_TEST_SUITE_P(Shipped, ExpertSeen, testing::Values("silver", "akin"));

}  // namespace
}  // namespace hallux::ui
