#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <tuple>

#include "assessment/assess.h"
#include "tests/ui/screens/operating/obedient_hand.h"

namespace hallux::ui {
namespace {

using simulator::CutEventKind;

int count_of(const VirtualOperation& operation, CutEventKind kind) {
  return static_cast<int>(std::ranges::count(operation.events(), kind, &simulator::CutEvent::kind));
}

/// piece_out and wedge_closed as they are scored.
std::vector<double> deeds_of(const VirtualOperation& operation) {
  const PreparedCase& prepared = operation.prepared_case();
  const assessment::Examination examination =
      assessment::assess_fully(prepared.scenario, prepared.bone, operation.recording());
  std::vector<double> deeds;
  for (const assessment::Measurement& made : examination.measurements)
    if (made.metric == "piece_out" || made.metric == "wedge_closed") deeds.push_back(made.value);
  EXPECT_FALSE(deeds.empty());
  return deeds;
}

class Coach : public testing::TestWithParam<std::tuple<std::string, int>> {};

TEST_P(Coach, LeadsOneWhoOnlyObeysToTheEnd) {
  const auto& [scenario, turn] = GetParam();
  VirtualOperation operation(scenario);
  operation.world_from_view =
      operation.world_from_view * glm::angleAxis(0.7 * turn, unit(Vec3(0.2, 1.0, 0.1)));
  while (operation.session().asked() == Asked::Nothing && operation.time_s() < 240.0) {
    const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
    if (!hint) {
      operation.advance(ticks_per_look);
      continue;
    }
    obey(operation, *hint);
  }
  EXPECT_EQ(operation.session().asked(), Asked::Finish) << "within four minutes";
  EXPECT_GE(count_of(operation, CutEventKind::PieceRemoved), 1);
  for (const double done : deeds_of(operation)) EXPECT_EQ(done, 1.0) << "as the score asks it";
}

INSTANTIATE_TEST_SUITE_P(Scenarios, Coach,
                         testing::Combine(testing::Values(std::string("silver"),
                                                          std::string("akin")),
                                          testing::Values(0, 1, -1, -2, 3)));

}  // namespace
}  // namespace hallux::ui
