#include "scenarios/site/site_watch.h"

#include <gtest/gtest.h>

#include "scenarios/site/kerf_of_cut.h"
#include "tests/scenarios/site/block_site.h"

namespace hallux::scenarios {
namespace {

using simulator::CutEvent;
using simulator::CutEventKind;
using tests::BlockSite;

constexpr double share_of_grid = 0.03;

CutEvent step_event(CutEventKind kind, std::int32_t step) {
  CutEvent event;
  event.kind = kind;
  event.subject = step;
  return event;
}

/// A site and who watches it.
struct Watched {
  explicit Watched(Scenario scenario) : site(std::move(scenario)) {}

  std::int32_t freeze(std::size_t cut, double shifted_mm = 0.0) {
    const CutEvent event = site.freeze(cut, shifted_mm);
    watch.apply(event, site.kerfs);
    return event.subject;
  }
  void say(CutEventKind kind, std::int32_t step) {
    watch.apply(step_event(kind, step), site.kerfs);
  }
  std::vector<HeldCut> held() {
    const std::array wholes{simulator::SolidWithTree{site.whole, site.bvh}};
    return watch.held(site.kerfs, wholes);
  }

  BlockSite site;
  SiteWatch watch{site.scenario, site.plan};
};

TEST(SiteWatch, WithoutAKerfAllOfACutHolds) {
  Watched watched(tests::along_scenario(40.0));
  ASSERT_EQ(watched.held().size(), 1U);
  EXPECT_FALSE(watched.held()[0].is_begun());
  EXPECT_EQ(watched.held()[0].share, 1.0);
}

TEST(SiteWatch, TellsTheShareAndTheSideThatStillHold) {
  Watched watched(tests::along_scenario(40.0));
  const std::int32_t kerf = watched.freeze(0);
  watched.site.saw(kerf, 0.0, 9.0);
  const HeldCut held = watched.held()[0];
  EXPECT_EQ(held.kerf, kerf);
  EXPECT_NEAR(held.share, 4.0 / 13.0, share_of_grid);
  EXPECT_EQ(held.side, "plantar");
  EXPECT_NEAR(held.deepest_in_bone_mm.y, -4.5, 0.5);
  EXPECT_FALSE(held.is_through());
  watched.site.saw(kerf, 0.0, 14.0);
  EXPECT_TRUE(watched.held()[0].is_through());
}

TEST(SiteWatch, OfAHingesCutAsksForTheSectionBeforeTheHingeAlone) {
  Watched watched(tests::wedge_scenario(16.0));
  watched.say(CutEventKind::StepDone, 0);
  const std::int32_t kerf = watched.freeze(0);
  // 15 mm in all; the thickest bridge on target begins 2 mm from the far side.
  watched.site.saw(kerf, 0.0, 13.2);
  EXPECT_TRUE(watched.held()[0].is_through());
}

TEST(SiteWatch, AKerfBelongsToTheStepAtHandAndElseToTheNearestPlan) {
  Watched watched(tests::wedge_scenario(16.0));
  watched.say(CutEventKind::StepDone, 0);
  watched.say(CutEventKind::StepDone, 1);
  // In the step of the second cut, but in the plane of the first.
  watched.site.saw(watched.freeze(0), 0.0, 8.0);
  EXPECT_FALSE(watched.held()[0].is_begun());
  EXPECT_TRUE(watched.held()[1].is_begun());
  watched.say(CutEventKind::StepReopened, 1);
  watched.site.saw(watched.freeze(1, 0.5), 0.0, 8.0);
  EXPECT_TRUE(watched.held()[0].is_begun());
  watched.say(CutEventKind::StepDone, 3);
  EXPECT_EQ(nearest_cut(watched.site.kerfs.plane(1), watched.site.plan), 1U);
}

TEST(SiteWatch, OfSeveralKerfsOfACutTheOneThatLeavesLeastCounts) {
  Watched watched(tests::along_scenario(40.0));
  const std::int32_t first = watched.freeze(0), second = watched.freeze(0, 2.0);
  watched.site.saw(first, 0.0, 3.0);
  watched.site.saw(second, 0.0, 14.0);
  const HeldCut held = watched.held()[0];
  EXPECT_EQ(held.kerf, second);
  EXPECT_TRUE(held.is_through());
}

TEST(SiteWatch, OfACutWithAWindowAsksForTheSectionWithinIt) {
  // The section is 33 mm long; what lies beyond its middle is to be sawn, by a blade as wide.
  Watched watched(tests::along_scenario(17.5));
  watched.site.plan.cuts[0].window = FaceWindow{{16.5, 0.0, 0.0}, {1.0, 0.0, 0.0}};
  const std::int32_t kerf = watched.freeze(0);
  watched.site.saw(kerf, 0.0, 14.0);
  const HeldCut held = watched.held()[0];
  EXPECT_NEAR(held.high_mm.y - held.low_mm.y, 16.5, 1.0e-6);
  EXPECT_TRUE(held.is_through()) << "the other half is not asked for";
}

TEST(SiteWatch, WhatAKerfLeftWhenItsFragmentWasDividedStays) {
  Watched watched(tests::along_scenario(40.0));
  const std::int32_t kerf = watched.freeze(0);
  watched.site.saw(kerf, 0.0, 3.0);
  const double share = watched.held()[0].share;
  CutEvent parted = step_event(CutEventKind::FragmentParted, 1);
  parted.value = 0;
  ASSERT_TRUE(watched.site.kerfs.apply(parted));
  watched.watch.apply(parted, watched.site.kerfs);
  EXPECT_EQ(watched.held()[0].share, share);
  EXPECT_EQ(watched.held()[0].fragment, 0);
}

}  // namespace
}  // namespace hallux::scenarios
