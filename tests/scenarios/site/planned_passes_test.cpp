#include "scenarios/site/planned_passes.h"

#include <gtest/gtest.h>

#include "tests/scenarios/site/block_site.h"

namespace hallux::scenarios {
namespace {

using tests::BlockSite;

PlannedPasses passes_of(const BlockSite& site, std::size_t cut) {
  return planned_passes(site.scenario, site.plan, cut, site.whole, site.bvh);
}

TEST(PlannedPasses, FeedComesFromTheSideOfTheApproach) {
  const BlockSite along(tests::along_scenario(12.0));
  EXPECT_NEAR(passes_of(along, 0).feed_in_bone.y, -1.0, 1.0e-12);
  const BlockSite wedge(tests::wedge_scenario(10.0));
  EXPECT_NEAR(passes_of(wedge, 0).feed_in_bone.z, 1.0, 1.0e-12);
  EXPECT_GT(passes_of(wedge, 1).feed_in_bone.z, 0.98);
}

TEST(PlannedPasses, OfABladeAsWideAsTheBoneAreOneOverItsMiddle) {
  const BlockSite site(tests::along_scenario(36.0));
  const PlannedPasses passes = passes_of(site, 0);
  EXPECT_NEAR(passes.high_mm - passes.low_mm, 33.0, 1.0e-6);
  ASSERT_EQ(passes.middles_mm.size(), 1U);
  EXPECT_NEAR(passes.middles_mm[0], 0.5 * (passes.low_mm + passes.high_mm), 1.0e-12);
}

TEST(PlannedPasses, OfANarrowBladeLieInEachOtherAndReachBeyondBothEdges) {
  const BlockSite site(tests::along_scenario(12.0));
  const PlannedPasses passes = passes_of(site, 0);
  ASSERT_EQ(passes.middles_mm.size(), 4U) << "35 mm, each of a width of 12 less 1 of overlap";
  EXPECT_NEAR(passes.middles_mm.front(), passes.low_mm - 1.0 + 6.0, 1.0e-9);
  EXPECT_NEAR(passes.middles_mm.back(), passes.high_mm + 1.0 - 6.0, 1.0e-9);
  for (std::size_t pass = 1; pass < passes.middles_mm.size(); ++pass)
    EXPECT_LE(passes.middles_mm[pass] - passes.middles_mm[pass - 1], 11.0);
}

TEST(PlannedPasses, BeforeAHingeSpanWhatIsToBeSawn) {
  const BlockSite site(tests::wedge_scenario(16.0));
  const PlannedPasses passes = passes_of(site, 0);
  EXPECT_NEAR(passes.high_mm - passes.low_mm, 13.0, 1.0e-6) << "from plantar to dorsal";
  EXPECT_EQ(passes.middles_mm.size(), 1U);
}

}  // namespace
}  // namespace hallux::scenarios
