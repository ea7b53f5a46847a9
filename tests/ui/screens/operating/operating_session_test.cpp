// What happens while somebody operates, without a window, a loop or a clock.
#include "ui/screens/operating/operating_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/operating/led_operation.h"

namespace hallux::ui {
namespace {

using simulator::CutEventKind;
using testing::ElementsAre;
using testing::IsEmpty;
using Phase = OperatingSession::Phase;
using Onward = OperatingSession::Onward;
using Staying = OperatingSession::Staying;

constexpr auto saw_bit = static_cast<std::uint32_t>(simulator::Switch::SawRuns);
constexpr auto irrigation_bit = static_cast<std::uint32_t>(simulator::Switch::Irrigates);

LiveEnd sealed() {
  LiveEnd end;
  end.end = simulator::AttemptEnd::Finished;
  end.is_sealed = true;
  return end;
}

// -- before

TEST(OperatingSession, BeginsOnceAndMayBeLeftUntilThen) {
  OperatingSession session(database::AttemptKind::Practice);
  EXPECT_FALSE(session.begin()) << "nothing is laid out yet";
  session.make_ready(StepProgress({scenarios::StepKind::Finish}), LedSaw());
  EXPECT_EQ(session.phase(), Phase::Ready);
  EXPECT_EQ(session.staying(), Staying::No);
  EXPECT_TRUE(session.begin());
  EXPECT_FALSE(session.begin());
  EXPECT_EQ(session.staying(), Staying::WhileRecorded);
  EXPECT_FALSE(session.is_heard()) << "nothing runs yet";
  session.take_back();
  EXPECT_TRUE(session.begin()) << "who stopped it may begin again";
}

TEST(OperatingSession, ThatCannotBeginSaysWhyAndMayBeLeft) {
  OperatingSession session(database::AttemptKind::Practice);
  session.make_ready({}, LedSaw());
  session.begin();
  session.fail_to_begin("the disk is full");
  EXPECT_EQ(session.phase(), Phase::Stopped);
  EXPECT_EQ(session.stop().failure, LiveFailure::Other);
  EXPECT_EQ(session.stop().reason, "the disk is full");
  EXPECT_EQ(session.staying(), Staying::No);
}

TEST(OperatingSession, HearsNobodyBeforeItRuns) {
  OperatingSession session(database::AttemptKind::Practice);
  session.make_ready({}, LedSaw());
  session.pause(PausedBy::Locked);
  session.ask(Asked::Finish);
  EXPECT_FALSE(session.pausing().is_paused());
  EXPECT_EQ(session.asked(), Asked::Nothing);
  EXPECT_FALSE(session.update_storage());
  EXPECT_EQ(session.take_end(), Onward::Nowhere);
}

// -- the hands

TEST(OperatingSession, SteersTheDeviceThatItWasGiven) {
  LedOperation operation;
  operation.session.set_irrigated(true);
  operation.saw(1.0);
  EXPECT_EQ(operation.device.switches, saw_bit | irrigation_bit);
  operation.lead({3.0, -2.0}, 1.1);
  EXPECT_EQ(operation.device.place_mm, start_mm + Vec3(3.0, -2.0, 0.0));
  EXPECT_EQ(operation.session.saw().world_from_target().translation_mm, operation.device.place_mm);
  EXPECT_THAT(operation.attempt.told, IsEmpty());
}

TEST(OperatingSession, ALiftedHandMovesWithoutTheSaw) {
  LedOperation operation;
  operation.session.lift(true);
  operation.lead({5.0, 0.0}, 1.0);
  EXPECT_EQ(operation.device.place_mm, start_mm);
  operation.session.lift(false);
  operation.lead({1.0, 0.0}, 1.1);
  EXPECT_EQ(operation.device.place_mm, start_mm + Vec3(1.0, 0.0, 0.0)) << "no jump";
}

TEST(OperatingSession, APauseTakesTheSawFromTheHandAndGoingOnDoesNotGiveItBack) {
  LedOperation operation;
  operation.session.set_irrigated(true);
  operation.saw(1.0);
  operation.session.toggle_pause();
  EXPECT_EQ(operation.device.switches, 0U);
  EXPECT_FALSE(operation.session.saw().is_on());
  EXPECT_FALSE(operation.session.is_led());
  operation.session.set_saw_on(true);
  EXPECT_FALSE(operation.session.saw().is_on()) << "nobody starts it in a pause";
  operation.session.toggle_pause();
  operation.lead({0.0, 0.0}, 1.2);
  EXPECT_EQ(operation.device.switches, irrigation_bit);
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "resume"));
}

TEST(OperatingSession, PausesWhereHandsAreTakenOffARunningSaw) {
  const auto cause_of = [](const HandsSeen& hands, double now_s) {
    LedOperation operation;
    operation.saw(1.0);
    operation.session.watch(hands, now_s);
    EXPECT_TRUE(operation.session.pausing().is_paused());
    EXPECT_THAT(operation.attempt.told, ElementsAre("pause"));
    return operation.session.pausing().by();
  };
  EXPECT_EQ(cause_of({.have_lost_keys = true}, 1.1), PausedBy::KeysLost);
  EXPECT_EQ(cause_of({.has_pointer_left = true}, 1.1), PausedBy::PointerLeft);
  EXPECT_EQ(cause_of({.is_covered = true}, 1.1), PausedBy::Covered);
  EXPECT_EQ(cause_of({}, 2.6), PausedBy::Stillness) << "the device has stopped it already";
}

TEST(OperatingSession, ASawThatIsOffIsTakenAwayByTheKeyboardAlone) {
  LedOperation operation;
  operation.session.watch({.has_pointer_left = true, .is_covered = true}, 100.0);
  EXPECT_FALSE(operation.session.pausing().is_paused());
  operation.session.watch({.have_lost_keys = true}, 100.0);
  EXPECT_EQ(operation.session.pausing().by(), PausedBy::KeysLost);
}

TEST(OperatingSession, ALostDeviceIsWaitedForAndItGoesOnByItself) {
  LedOperation operation;
  operation.saw(1.0);
  operation.session.see_device(true);
  EXPECT_EQ(operation.session.pausing().by(), PausedBy::DeviceLost);
  EXPECT_TRUE(operation.session.is_device_lost());
  operation.session.go_on();
  EXPECT_TRUE(operation.session.pausing().is_paused()) << "there is nothing to go on with";
  operation.session.see_device(true);
  operation.session.see_device(false);
  EXPECT_FALSE(operation.session.pausing().is_paused());
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "resume"));
}

TEST(OperatingSession, WhatPausedBeforeTheDeviceWasLostStaysPaused) {
  LedOperation operation;
  operation.session.pause(PausedBy::Person);
  operation.session.see_device(true);
  operation.session.see_device(false);
  EXPECT_TRUE(operation.session.pausing().is_paused());
  EXPECT_EQ(operation.session.pausing().by(), PausedBy::Person);
}

TEST(OperatingSession, OnlyAPracticeGoesOnWithTheMouse) {
  for (const auto kind : {database::AttemptKind::Practice, database::AttemptKind::Assessment}) {
    LedOperation operation(kind);
    operation.device.leads = simulator::SteeredDevice::Led::Rotation;
    operation.session.see_saw({Quat(1.0, 0.0, 0.0, 0.0), start_mm}, 0);
    operation.session.take_over_from_device();
    EXPECT_FALSE(operation.session.saw().is_led_by_window()) << "it is there";
    operation.session.see_device(true);
    operation.session.take_over_from_device();
    EXPECT_EQ(operation.session.saw().is_led_by_window(), kind == database::AttemptKind::Practice);
  }
}

TEST(OperatingSession, TheCauseOfAPauseIsTheFirst) {
  LedOperation operation;
  operation.session.pause(PausedBy::Covered);
  operation.session.pause(PausedBy::Locked);
  EXPECT_EQ(operation.session.pausing().by(), PausedBy::Covered);
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause"));
}

// -- steps

TEST(OperatingSession, DeclaresStepsAsTheyAreDoneAndAsksAtTheLast) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.press_step(true, 1.0);
  session.press_step(true, 2.0);
  session.see(std::vector<scenarios::WantedPart>{{{3, 1}, true}});
  session.press_step(true, 3.0);
  session.press_step(true, 3.1);
  EXPECT_THAT(operation.attempt.told, ElementsAre("done 0", "done 1", "pick up 3"))
      << "a step that waits is not pressed again";
  session.apply(std::vector{event_of(CutEventKind::PieceRemoved, 3)}, 3.5);
  EXPECT_EQ(session.steps().step(), 2U) << "a crumb of it still lies there";
  session.apply(std::vector{event_of(CutEventKind::PieceRemoved, 1)}, 4.0);
  session.press_step(true, 5.0);
  session.apply(std::vector{event_of(CutEventKind::HingeClosed)}, 6.0);
  EXPECT_EQ(session.steps().step(), 4U);
  session.press_step(true, 7.0);
  EXPECT_EQ(session.asked(), Asked::Finish);
  EXPECT_THAT(operation.attempt.told, ElementsAre("done 0", "done 1", "pick up 3", "pick up 1",
                                                  "done 2", "close hinge 0", "done 3", "pause"));
}

TEST(OperatingSession, TellsWhatDidNotComeOff) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  EXPECT_THAT(session.apply(std::vector{event_of(CutEventKind::KerfRefused)}, 1.0),
              ElementsAre(Notice::KerfRefused));
  session.press_step(true, 1.0);
  session.press_step(true, 1.0);
  session.see(std::vector<scenarios::WantedPart>{{{1}, true}});
  session.press_step(true, 1.0);
  EXPECT_THAT(session.apply({}, 20.9), IsEmpty());
  EXPECT_THAT(session.apply({}, 21.0), ElementsAre(Notice::NothingFree));
  EXPECT_THAT(session.apply({}, 50.0), IsEmpty()) << "said once";
}

TEST(OperatingSession, AsksOnceWhetherAStepEndsWhoseCutStillHolds) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.press_step(true, 1.0);
  session.press_step(false, 2.0);
  EXPECT_EQ(session.asked(), Asked::EndUnfinished);
  session.answer(Decided::GoOn, 2.5);
  EXPECT_EQ(session.steps().step(), 1U) << "one saws on";
  session.press_step(false, 3.0);
  EXPECT_EQ(session.asked(), Asked::Nothing) << "once";
  EXPECT_EQ(session.steps().step(), 2U);
  EXPECT_THAT(operation.attempt.told, ElementsAre("done 0", "pause", "resume", "done 1"));
}

TEST(OperatingSession, TakesAStepUpAgainAndGoesOnAfterIt) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.press_step(true, 1.0);
  session.press_step(true, 2.0);
  session.take_up_step(1);
  EXPECT_EQ(session.steps().step(), 1U);
  EXPECT_FALSE(session.steps().is_done(1));
  session.press_step(true, 3.0);
  EXPECT_EQ(session.steps().step(), 2U);
  EXPECT_THAT(operation.attempt.told, ElementsAre("done 0", "done 1", "reopen 1", "done 1"));
}

// -- questions

TEST(OperatingSession, AsksInAPauseAndGoesOnAsItWas) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.ask(Asked::Abandon);
  EXPECT_TRUE(session.pausing().is_paused());
  EXPECT_FALSE(session.is_open());
  session.ask(Asked::Finish);
  EXPECT_EQ(session.asked(), Asked::Abandon) << "one question at a time";
  session.answer(Decided::GoOn, 1.0);
  EXPECT_TRUE(session.is_led());
  session.pause(PausedBy::Person);
  session.ask(Asked::Abandon);
  session.answer(Decided::GoOn, 2.0);
  EXPECT_TRUE(session.pausing().is_paused()) << "it was paused before";
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "resume", "pause"));
}

// -- the end

TEST(OperatingSession, ThatIsFinishedIsSealedAndScored) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.ask(Asked::Finish);
  session.answer(Decided::Act, 5.0);
  EXPECT_EQ(session.phase(), Phase::Sealing);
  EXPECT_EQ(session.ended_s(), 5.0);
  EXPECT_EQ(session.take_end(), Onward::Nowhere);
  EXPECT_EQ(session.staying(), Staying::WhileRecorded);
  operation.end_with(sealed());
  EXPECT_EQ(session.take_end(), Onward::Score);
  EXPECT_EQ(session.take_end(), Onward::Nowhere) << "once";
  EXPECT_EQ(session.staying(), Staying::WhileScored);
  session.close();
  EXPECT_EQ(session.staying(), Staying::No);
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "finish"));
}

TEST(OperatingSession, ThatIsAbandonedIsOverWithoutAScore) {
  LedOperation operation;
  operation.session.ask(Asked::Abandon);
  operation.session.answer(Decided::Act, 5.0);
  operation.end_with({});
  EXPECT_EQ(operation.session.take_end(), Onward::Abandoned);
  EXPECT_EQ(operation.session.phase(), Phase::Over);
  EXPECT_EQ(operation.session.staying(), Staying::No);
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "abandon"));
}

TEST(OperatingSession, ThatIsLeftIsFinishedOrAbandonedAsThePersonDecides) {
  const auto told_after = [](Decided decided) {
    LedOperation operation;
    operation.saw(1.0);
    operation.session.ask(Asked::Leave);
    EXPECT_FALSE(operation.session.saw().is_on()) << "a question stops the saw";
    operation.session.answer(decided, 2.0);
    return operation.attempt.told;
  };
  EXPECT_THAT(told_after(Decided::Finish), ElementsAre("pause", "finish"));
  EXPECT_THAT(told_after(Decided::Act), ElementsAre("pause", "abandon"));
  EXPECT_THAT(told_after(Decided::GoOn), ElementsAre("pause", "resume"));
}

TEST(OperatingSession, ThatRanToItsLastTickIsScored) {
  LedOperation operation;
  operation.session.ask(Asked::Abandon);
  operation.end_with(sealed());
  EXPECT_EQ(operation.session.take_end(), Onward::Score);
  EXPECT_EQ(operation.session.asked(), Asked::Nothing) << "there is nothing left to abandon";
}

TEST(OperatingSession, AFailureStopsItAndTheSaw) {
  LedOperation operation;
  operation.saw(1.0);
  LiveEnd end;
  end.failure = LiveFailure::MemoryFull;
  end.reason = "no memory";
  end.file = "course.db";
  operation.end_with(end);
  EXPECT_EQ(operation.session.take_end(), Onward::Stopped);
  EXPECT_EQ(operation.session.stop().failure, LiveFailure::MemoryFull);
  EXPECT_EQ(operation.session.stop().reason, "no memory");
  EXPECT_EQ(operation.session.stop().file, "course.db");
  EXPECT_FALSE(operation.session.saw().is_on());
  EXPECT_EQ(operation.session.staying(), Staying::No);
}

// -- the disk

TEST(OperatingSession, AFullDiskPausesUntilThereIsRoomAndSomebodyGoesOn) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  operation.attempt.is_full = true;
  EXPECT_TRUE(session.update_storage());
  EXPECT_FALSE(session.update_storage()) << "said once";
  EXPECT_TRUE(session.pausing().is_storage_full());
  session.toggle_pause();
  EXPECT_TRUE(session.pausing().is_paused()) << "nobody goes on without room";
  operation.attempt.is_full = false;
  EXPECT_TRUE(session.update_storage());
  EXPECT_EQ(session.pausing().by(), PausedBy::RoomAgain);
  EXPECT_FALSE(session.is_led());
  session.go_on();
  EXPECT_TRUE(session.is_led());
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "resume"));
}

TEST(OperatingSession, ADiskThatFillsUpBesideAQuestionKeepsItPaused) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.ask(Asked::Abandon);
  operation.attempt.is_full = true;
  session.update_storage();
  session.answer(Decided::GoOn, 1.0);
  EXPECT_TRUE(session.pausing().is_storage_full());
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause"));
}

TEST(OperatingSession, WhoDoesNotWaitForRoomIsStoppedAndKeepsWhatWasSaved) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  operation.attempt.is_full = true;
  session.update_storage();
  session.abandon_unstored(3.0);
  EXPECT_EQ(session.phase(), Phase::Sealing);
  LiveEnd end;
  end.failure = LiveFailure::DiskFull;
  operation.end_with(end);
  EXPECT_EQ(session.take_end(), Onward::Stopped);
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "abandon"));
}

TEST(OperatingSession, ADiskThatFillsUpWhileSealingIsWaitedForToo) {
  LedOperation operation;
  OperatingSession& session = operation.session;
  session.ask(Asked::Finish);
  session.answer(Decided::Act, 1.0);
  operation.attempt.is_full = true;
  EXPECT_TRUE(session.update_storage());
  EXPECT_TRUE(session.pausing().is_storage_full());
  operation.attempt.is_full = false;
  EXPECT_TRUE(session.update_storage());
  EXPECT_EQ(session.phase(), Phase::Sealing);
  EXPECT_THAT(operation.attempt.told, ElementsAre("pause", "finish"));
}

}  // namespace
}  // namespace hallux::ui
