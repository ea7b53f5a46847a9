// A device that is pulled out while somebody operates with it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "simulator/device/mouse.h"
#include "tests/ui/screens/operating/some_operation.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using database::AttemptState;
using testing::IsEmpty;

/// An arm of three joints whose plug is the test's.
class LosableArm final : public simulator::SteeredDevice {
 public:
  LosableArm(const RigidTransform& world_from_start, std::shared_ptr<std::atomic<bool>> is_out)
      : hand_(world_from_start), is_out_(std::move(is_out)) {}

  void aim(const Aim& aim) noexcept override { hand_.aim(aim); }
  Led led() const noexcept override { return is_handed_over_ ? Led::Pose : Led::Rotation; }
  simulator::TroubleReport trouble() const override {
    if (!*is_out_ || is_handed_over_) return {};
    return {simulator::DeviceTrouble::Unplugged, {}, {}};
  }
  void hand_over(const RigidTransform&) override { is_handed_over_ = true; }
  simulator::DeviceDescription description() const override { return {"Falcon", "arm3"}; }
  std::optional<simulator::DeviceFacts> facts() const override {
    return simulator::DeviceFacts{"falcon", "Falcon", "arm3", "libusb", 1.0, {}};
  }
  bool exchange(const Vec3& force_in_world_newton, std::int64_t tick,
                simulator::RawDeviceState& state) noexcept override {
    state.is_handed_over = is_handed_over_;
    if (*is_out_ && !is_handed_over_) return false;
    const bool is_there = hand_.exchange(force_in_world_newton, tick, state);
    state.is_handed_over = is_handed_over_;
    return is_there;
  }

 private:
  simulator::MouseDevice hand_;
  std::shared_ptr<std::atomic<bool>> is_out_;
  std::atomic<bool> is_handed_over_{false};
};

class LostDevice : public testing::Test {
 protected:
  void operate(AttemptKind kind) {
    person_ = std::make_unique<Operator>(
        course_, kind, 1.0F, Point{1440.0F, 900.0F}, nullptr,
        [is_out = is_out_](const HandStart& start, const Progress&) {
          return LentHands{std::make_unique<LosableArm>(start.world_from_tool, is_out)};
        });
    person_->begin();
  }
  void pull(const char* button) {
    *is_out_ = true;
    ASSERT_TRUE(person_->until([&] { return person_->driver().has(button); }));
    EXPECT_THAT(person_->driver().faults(), IsEmpty());
  }
  bool has(std::string_view id) const { return person_->driver().has(id); }

  OperableCourse course_{"silver", 1.5};
  std::shared_ptr<std::atomic<bool>> is_out_ = std::make_shared<std::atomic<bool>>(false);
  std::unique_ptr<Operator> person_;
};

TEST_F(LostDevice, IsWaitedForWithItsReasonAndTheOperationGoesOnByItself) {
  operate(AttemptKind::Practice);
  pull("operate.lost.mouse");
  EXPECT_TRUE(person_->driver().sees("Novint Falcon: it was unplugged"));
  person_->press(Key::P);
  person_->make_frames(3);
  EXPECT_TRUE(has("operate.lost.mouse")) << "there is nothing to go on with";
  *is_out_ = false;
  EXPECT_TRUE(person_->until([&] { return !has("operate.lost.mouse"); }));
  EXPECT_FALSE(has("operate.go_on")) << "it runs";
}

TEST_F(LostDevice, InAPracticeTheMouseTakesOver) {
  operate(AttemptKind::Practice);
  pull("operate.lost.mouse");
  person_->click("operate.lost.mouse");
  EXPECT_TRUE(person_->until([&] { return !has("operate.lost.mouse"); }));
  EXPECT_FALSE(has("operate.go_on"));
}

TEST_F(LostDevice, InAnAssessmentNobodyTakesOverAndGivenUpItIsInterrupted) {
  operate(AttemptKind::Assessment);
  pull("operate.lost.abandon");
  EXPECT_FALSE(has("operate.lost.mouse"));
  person_->click("operate.lost.abandon");
  ASSERT_TRUE(person_->until([&] { return has("operate.ask_abandon.keep"); }));
  person_->click("operate.ask_abandon.keep");
  ASSERT_TRUE(person_->until([&] { return has("operate.lost.abandon"); })) << "it waits on";
  person_->click("operate.lost.abandon");
  ASSERT_TRUE(person_->until([&] { return has("operate.ask_abandon.act"); }));
  person_->click("operate.ask_abandon.act");
  ASSERT_TRUE(person_->until([&] { return person_->is_gone(); }));
  EXPECT_EQ(course_.newest_attempt().state, AttemptState::Interrupted);
}

TEST_F(LostDevice, OneThatComesBackWhileSomethingIsAskedGoesOnWithTheAnswer) {
  operate(AttemptKind::Assessment);
  pull("operate.lost.abandon");
  person_->click("operate.lost.abandon");
  ASSERT_TRUE(person_->until([&] { return has("operate.ask_abandon.keep"); }));
  *is_out_ = false;
  person_->make_frames(30);
  person_->click("operate.ask_abandon.keep");
  EXPECT_TRUE(person_->until([&] { return !has("operate.ask_abandon.keep"); }));
  person_->make_frames(3);
  EXPECT_FALSE(has("operate.lost.abandon"));
  EXPECT_FALSE(has("operate.go_on")) << "it runs";
}

TEST_F(LostDevice, OneThatCannotBeHadLeavesTheOperationReadyToBegin) {
  auto tries = std::make_shared<std::atomic<int>>(0);
  Operator person(course_, AttemptKind::Practice, 1.0F, {1440.0F, 900.0F}, nullptr,
                  [tries](const HandStart& start, const Progress& progress) {
                    if ((*tries)++ == 0) throw DeviceRefused("falcon: is not plugged in");
                    return some_mouse(start, progress);
                  });
  ASSERT_TRUE(person.until([&] { return person.driver().has("operate.begin"); }));
  person.click("operate.begin");
  ASSERT_TRUE(person.until([&] { return person.driver().sees("is not plugged in"); }));
  EXPECT_TRUE(person.driver().sees("The device cannot be used"));
  person.begin();
  EXPECT_EQ(*tries, 2);
}

}  // namespace
}  // namespace hallux::ui
