// A chevron from the first look to the last, by somebody who only obeys what the coach says: no
// operation is known by name, so whoever follows the hints of another comes as far.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/screens/operating/fixation/chevron_case.h"
#include "tests/ui/screens/operating/obedient_hand.h"
#include "ui/screens/operating/fixation_hints.h"

namespace hallux::ui {
namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

constexpr double patience_s = 900.0;

class ChevronByHints : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    operation = new VirtualOperation(chevron_case());
    while (operation->time_s() < patience_s && operation->session().asked() != Asked::Finish) {
      const std::optional<Hint> hint = next_hint(coach_view(operation->sources()));
      obey(*operation, hint.value_or(Hint{}));
    }
  }
  static void TearDownTestSuite() {
    delete operation;
    operation = nullptr;
  }
  static long count(CutEventKind kind) {
    return std::ranges::count(operation->events(), kind, &CutEvent::kind);
  }

  static VirtualOperation* operation;
};

VirtualOperation* ChevronByHints::operation = nullptr;

TEST_F(ChevronByHints, ComesToTheLastStep) {
  EXPECT_EQ(operation->session().asked(), Asked::Finish);
  for (std::size_t step = 0; step + 1 < operation->prepared_case().scenario.steps.size(); ++step)
    EXPECT_TRUE(operation->session().steps().is_done(step)) << step;
}

TEST_F(ChevronByHints, PartsTheHeadLeadsItToItsPlaceAndDrivesItHome) {
  EXPECT_EQ(count(CutEventKind::FragmentParted), 1);
  EXPECT_EQ(count(CutEventKind::Gripped), 1);
  const SiteFacts& site = *operation->site();
  ASSERT_EQ(site.bone_from_fragments.size(), 2U);
  const ShiftReading lies =
      read_shift(operation->prepared_case().plan, 0, site.bone_from_fragments[1]);
  EXPECT_NEAR(lies.moved_mm, 5.0, 1.0);
  EXPECT_LT(lies.turned_rad, 0.1);
}

TEST_F(ChevronByHints, LeavesTheScrewAndTakesTheWiresOut) {
  const SiteFacts& site = *operation->site();
  ASSERT_EQ(site.implants.size(), 1U);
  const scenarios::LaidOutTool& tool =
      operation->session().tools().tray()[static_cast<std::size_t>(site.implants[0].tool)];
  EXPECT_TRUE(std::holds_alternative<simulator::Screwdriver>(tool.tool)) << tool.name;
  EXPECT_EQ(count(CutEventKind::ImplantTaken), 2);
}

}  // namespace
}  // namespace hallux::ui
