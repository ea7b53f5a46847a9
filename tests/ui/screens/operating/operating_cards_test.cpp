#include "ui/screens/operating/operating_cards.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using scenarios::load_shipped_scenario;
using scenarios::Scenario;
using scenarios::StepKind;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// Ends one step after the other until one of that kind is at hand.
void go_on_to(StepProgress& progress, StepKind kind) {
  while (progress.kind() && progress.kind() != kind) progress.end_step();
  ASSERT_EQ(progress.kind(), kind);
}

std::string left_of(const Scenario& scenario, const StepProgress& progress) {
  return left_steps_text(english_texts(), scenario, progress);
}

TEST(LeftSteps, AreToldByTitleWithoutThoseThatMayBeLeftOutAndTheFinishItself) {
  const Scenario chevron = load_shipped_scenario("chevron");
  StepProgress progress(chevron);
  EXPECT_THAT(left_of(chevron, progress),
              AllOf(StartsWith("11 steps are not done: Verify the case, Cut the eminence, "),
                    HasSubstr("Plantar arm, Shift the head and 3 more."),
                    Not(HasSubstr("Set the retractors")), Not(HasSubstr("Check and finish"))));
  go_on_to(progress, StepKind::TemporaryWire);
  EXPECT_EQ(left_of(chevron, progress),
            "3 steps are not done: Hold it with a wire, Set the screw, Trim the overhang.");
  go_on_to(progress, StepKind::Trim);
  EXPECT_EQ(left_of(chevron, progress), "1 step is not done: Trim the overhang.");
  go_on_to(progress, StepKind::Finish);
  EXPECT_EQ(left_of(chevron, progress), "All steps are done.");
}

TEST(LeftSteps, AStepTakenUpAgainIsLeftAgain) {
  const Scenario chevron = load_shipped_scenario("chevron");
  StepProgress progress(chevron);
  go_on_to(progress, StepKind::Finish);
  progress.reopen(1);
  EXPECT_EQ(left_of(chevron, progress), "1 step is not done: Cut the eminence.");
}

TEST(LeftSteps, AlternativesOfWhichNoneIsDoneAreToldTogether) {
  const Scenario akin = load_shipped_scenario("akin");
  StepProgress progress(akin);
  go_on_to(progress, StepKind::Fix);
  EXPECT_EQ(left_of(akin, progress), "1 step is not done: Set the screw or Set two crossed wires.");
  progress.end_step();
  EXPECT_EQ(left_of(akin, progress), "All steps are done.") << "one of them suffices";
}

TEST(LeftSteps, AChainTellsThemToo) {
  Scenario chain;
  for (const auto& [kind, title] :
       {std::pair(StepKind::Verify, "Verify the case"), std::pair(StepKind::Cut, "First cut"),
        std::pair(StepKind::Finish, "Finish")}) {
    scenarios::OperationStep& step = chain.steps.emplace_back();
    step.kind = kind;
    step.title = title;
  }
  StepProgress progress(chain);
  EXPECT_EQ(left_of(chain, progress), "2 steps are not done: Verify the case, First cut.");
  go_on_to(progress, StepKind::Finish);
  EXPECT_EQ(left_of(chain, progress), "All steps are done.");
}

std::string all_text(const Driver& driver) {
  std::string words;
  for (const std::string& text : driver.texts()) words += text + " ";
  return words;
}

TEST(EndQuestion, SaysWhatIsLeftAndIsCutOffNowhere) {
  const Texts texts = english_texts();
  const Scenario chevron = load_shipped_scenario("chevron");
  const EndWords words{"", left_steps_text(texts, chevron, StepProgress(chevron))};
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Driver driver(texts, [&](Ui& ui) { draw_end_question(ui, Asked::Finish, words); },
                  {1280.0F, 720.0F, scale});
    EXPECT_THAT(driver.faults(), IsEmpty()) << scale;
    EXPECT_THAT(all_text(driver),
                AllOf(HasSubstr("11 steps are not done"), HasSubstr("sealed and scored as it is")));
  }
}

}  // namespace
}  // namespace hallux::ui
