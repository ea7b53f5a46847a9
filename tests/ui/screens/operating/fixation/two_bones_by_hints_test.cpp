// An operation on two bones, by somebody who only obeys what the coach says: what is read, aimed at
// and led on the second bone lies where the first one's frame says.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/screens/operating/obedient_hand.h"
#include "ui/screens/operating/fixation_hints.h"

namespace hallux::ui {
namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

constexpr double patience_s = 900.0;

PreparedCase two_bones_case() {
  return prepare_case(scenarios::read_scenario(HALLUX_TWO_BONES),
                      [](const std::string&) { return Progress(); });
}

TEST(TwoBonesByHints, AreSawnThroughAndWhatIsPartedIsLedAndPinned) {
  VirtualOperation operation(two_bones_case());
  while (operation.time_s() < patience_s && operation.session().asked() != Asked::Finish)
    obey(operation, next_hint(coach_view(operation.sources())).value_or(Hint{}));
  ASSERT_EQ(operation.session().asked(), Asked::Finish)
      << "at " << operation.time_s() << " s, step " << operation.session().steps().step();
  const auto count = [&](CutEventKind kind) {
    return std::ranges::count(operation.events(), kind, &CutEvent::kind);
  };
  EXPECT_EQ(count(CutEventKind::PieceRemoved), 1);
  EXPECT_EQ(count(CutEventKind::FragmentParted), 1);
  const SiteFacts& site = *operation.site();
  ASSERT_EQ(site.moved.size(), 3U) << "two bones and the end of the toe";
  const ShiftReading lies = read_shift(operation.prepared_case().plan_in_first, 0, site.moved[2]);
  EXPECT_NEAR(lies.moved_mm, 3.0, 1.0);
  EXPECT_LT(lies.turned_rad, 0.1);
  ASSERT_EQ(site.implants.size(), 1U);
}

}  // namespace
}  // namespace hallux::ui
