#include "ui/screens/operating/hand/tools_in_hand.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "simulator/record/refusals.h"
#include "tests/ui/screens/operating/led_operation.h"

namespace hallux::ui {
namespace {

using simulator::CutEventKind;
using testing::ElementsAre;
using testing::IsEmpty;

std::vector<scenarios::LaidOutTool> small_tray() {
  return {{"blade", simulator::Saw{}},
          {"wire 1.6", simulator::WireDriver{}},
          {"drill 2.0", simulator::Drill{}},
          {"screw 2.7x20", simulator::Screwdriver{}}};
}

std::optional<Notice> apply(ToolsInHand& tools, CutEventKind kind, std::int32_t subject) {
  return tools.apply(event_of(kind, subject));
}

TEST(ToolsInHand, TheFirstOfTheTrayIsHeldUntilTheLoopSaysThatAnotherIs) {
  ToolsInHand tools(small_tray());
  EXPECT_TRUE(tools.is_saw());
  apply(tools, CutEventKind::ToolChosen, 3);
  EXPECT_EQ(tools.place(), 3);
  EXPECT_EQ(tools.tool()->name, "screw 2.7x20");
  EXPECT_FALSE(tools.is_saw());
  EXPECT_TRUE(tools.is_implant_driver());
  apply(tools, CutEventKind::ToolChosen, 2);
  EXPECT_FALSE(tools.is_implant_driver()) << "a drill leaves nothing";
}

TEST(ToolsInHand, WithoutATrayASawIsAllThereIs) {
  const ToolsInHand tools;
  EXPECT_TRUE(tools.is_saw());
  EXPECT_EQ(tools.tool(), nullptr);
}

TEST(ToolsInHand, ForcepsHoldFromTheGripToTheRelease) {
  ToolsInHand tools(small_tray());
  tools.close_forceps();
  EXPECT_EQ(tools.forceps(), Forceps::Closing);
  apply(tools, CutEventKind::Gripped, 1);
  EXPECT_EQ(tools.forceps(), Forceps::Holding);
  EXPECT_EQ(tools.gripped(), 1);
  tools.drive_home();
  EXPECT_TRUE(tools.was_driven_home());
  apply(tools, CutEventKind::Released, 1);
  EXPECT_EQ(tools.forceps(), Forceps::Open);
  EXPECT_EQ(tools.gripped(), -1);
  apply(tools, CutEventKind::Gripped, 1);
  EXPECT_FALSE(tools.was_driven_home()) << "that was the grip before";
}

TEST(ToolsInHand, EachRefusalIsToldAndClosesNothing) {
  using simulator::GripRefusal;
  ToolsInHand tools(small_tray());
  tools.close_forceps();
  const auto refused = [&](CutEventKind kind, auto why) {
    return apply(tools, kind, static_cast<std::int32_t>(why));
  };
  EXPECT_EQ(refused(CutEventKind::GripRefused, GripRefusal::Held), Notice::PieceFixed);
  EXPECT_EQ(tools.forceps(), Forceps::Open);
  EXPECT_EQ(refused(CutEventKind::GripRefused, GripRefusal::NoSuchPiece), Notice::NothingToGrip);
  EXPECT_EQ(refused(CutEventKind::GripRefused, GripRefusal::BoneItself), Notice::BoneItself);
  EXPECT_EQ(refused(CutEventKind::GripRefused, GripRefusal::ToolInBone), Notice::ToolInBone);
  EXPECT_EQ(refused(CutEventKind::GripRefused, GripRefusal::TooMany), Notice::TooManyMoved);
  EXPECT_EQ(refused(CutEventKind::ToolRefused, simulator::ToolRefusal::HandsFull),
            Notice::HandsFull);
  EXPECT_EQ(refused(CutEventKind::ToolRefused, simulator::ToolRefusal::ToolInBone),
            Notice::ToolInBone);
  using simulator::ImplantRefusal;
  EXPECT_EQ(refused(CutEventKind::ImplantRefused, ImplantRefusal::NothingToLeave),
            Notice::NothingToLeave);
  EXPECT_EQ(refused(CutEventKind::ImplantRefused, ImplantRefusal::OtherTool),
            Notice::NothingToTake);
  EXPECT_EQ(refused(CutEventKind::ImplantRefused, ImplantRefusal::TooMany), Notice::TooManyLeft);
  EXPECT_EQ(apply(tools, CutEventKind::BoreRefused, -1), Notice::BoreRefused);
  EXPECT_EQ(apply(tools, CutEventKind::MetalMet, 0), Notice::MetalMet);
}

TEST(ToolsInHand, AScrewIsSeatedUntilItIsLeftOrAnotherToolIsTaken) {
  ToolsInHand tools(small_tray());
  apply(tools, CutEventKind::ScrewSeated, 0);
  EXPECT_TRUE(tools.is_seated());
  apply(tools, CutEventKind::ImplantLeft, 2);
  EXPECT_FALSE(tools.is_seated()) << "of the screw that was left";
}

// -- what the session tells the attempt

class AnOperationWithATray : public testing::Test {
 protected:
  AnOperationWithATray() {
    session_.make_ready(StepProgress({scenarios::StepKind::Fix}), LedSaw(),
                        ToolsInHand(small_tray()));
    session_.begin();
    session_.run(attempt_, device_);
  }
  void said(CutEventKind kind, std::int32_t subject) {
    session_.apply(std::vector{event_of(kind, subject)}, 1.0);
  }

  NotedAttempt attempt_;
  NotedDevice device_;
  OperatingSession session_{database::AttemptKind::Practice};
};

TEST_F(AnOperationWithATray, ChoosesWithTheDriveOffWhileTheTimeGoesOn) {
  session_.set_saw_on(true);
  session_.open_tray();
  EXPECT_EQ(session_.asked(), Asked::Tool);
  EXPECT_FALSE(session_.saw().is_on());
  EXPECT_FALSE(session_.is_led()) << "nobody leads while the tray is looked at";
  EXPECT_FALSE(session_.pausing().is_paused());
  session_.close_tray(2);
  EXPECT_TRUE(session_.is_led());
  session_.open_tray();
  session_.close_tray({});
  session_.open_tray();
  session_.close_tray(0);
  EXPECT_THAT(attempt_.told, ElementsAre("take 2")) << "the one in the hand is not taken anew";
}

TEST_F(AnOperationWithATray, GripsDrivesHomeAndLetsGo) {
  session_.work_forceps(std::nullopt);
  EXPECT_THAT(attempt_.told, IsEmpty()) << "nothing lies free";
  session_.work_forceps(4);
  EXPECT_EQ(session_.tools().forceps(), Forceps::Closing);
  session_.drive_home();
  said(CutEventKind::Gripped, 1);
  session_.drive_home();
  session_.work_forceps(std::nullopt);
  EXPECT_THAT(attempt_.told, ElementsAre("grip 4", "impact", "release"));
}

TEST_F(AnOperationWithATray, LeavesWhatStandsInBoneAndTakesWhatItLeft) {
  session_.leave_or_take(true, std::nullopt);
  EXPECT_THAT(attempt_.told, IsEmpty()) << "a saw leaves nothing";
  said(CutEventKind::ToolChosen, 1);
  session_.leave_or_take(true, 0);
  session_.leave_or_take(false, 0);
  session_.leave_or_take(false, std::nullopt);
  EXPECT_THAT(attempt_.told, ElementsAre("leave", "take hold 0", "leave"));
}

TEST_F(AnOperationWithATray, HearsNoToolWhilePaused) {
  session_.pause(PausedBy::Person);
  session_.open_tray();
  session_.work_forceps(1);
  EXPECT_EQ(session_.asked(), Asked::Nothing);
  EXPECT_THAT(attempt_.told, ElementsAre("pause"));
}

}  // namespace
}  // namespace hallux::ui
