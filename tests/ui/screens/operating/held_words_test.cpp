#include "ui/screens/operating/hud_facts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/operating/forked_block.h"
#include "tests/ui/screens/operating/obedient_hand.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using scenarios::StepKind;
using testing::ContainsRegex;

/// Somebody who ended the one cut half sawn, and drew the blade out.
class AHalfSawnCut : public testing::Test {
 protected:
  std::string reason_in(AttemptKind kind) {
    PreparedCase prepared = forked_case(16.0);
    VirtualOperation operation(std::move(prepared), kind);
    const auto share = [&] {
      return operation.site() == nullptr ? 1.0 : operation.site()->cuts.front().share;
    };
    while (share() > 0.56 && operation.time_s() < 120.0) {
      const std::optional<Hint> hint = next_hint(coach_view(operation.sources()));
      obey(operation, hint.value_or(Hint{}));
    }
    EXPECT_LE(share(), 0.56);
    for (int i = 0; i < 3; ++i) obey(operation, draw_back_hint("operate.hint.clear", 8.0));
    operation.press_step();
    operation.session().answer(Decided::Act, operation.time_s());
    operation.advance(ticks_per_look);
    EXPECT_EQ(operation.session().steps().kind(), StepKind::Remove);
    held_ = operation.site()->cuts.front();
    return hud_of(operation.sources(), true).why_step_off;
  }
  scenarios::HeldCut held_;
};

TEST_F(AHalfSawnCut, SaysInPracticeHowMuchHoldsAndWhere) {
  const std::string reason = reason_in(AttemptKind::Practice);
  EXPECT_THAT(reason,
              ContainsRegex("^Still held: [0-9]+ % of the section, [a-z]*dorsal[-a-z]*[.]$"));
  EXPECT_EQ(reason, held_text(english_texts(), held_));
}

TEST_F(AHalfSawnCut, SaysInAnAssessmentThatThePieceHoldsAndNoMore) {
  EXPECT_EQ(reason_in(AttemptKind::Assessment), "The piece is still held.");
}

TEST(HeldText, LeavesOutASideThatThereIsNot) {
  scenarios::HeldCut held;
  held.kerf = 0;
  held.share = 0.152;
  EXPECT_EQ(held_text(english_texts(), held), "Still held: 15 % of the section.");
  held.side = "plantar-distal";
  EXPECT_EQ(held_text(english_texts(), held), "Still held: 15 % of the section, plantar-distal.");
  held.share = 0.0005;
  EXPECT_EQ(held_text(english_texts(), held), "Still held: 1 % of the section, plantar-distal.")
      << "what holds is never nothing";
}

}  // namespace
}  // namespace hallux::ui
