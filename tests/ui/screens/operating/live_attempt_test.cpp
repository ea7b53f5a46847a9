#include "ui/jobs/live_attempt.h"

#include <gtest/gtest.h>

#include "tests/ui/screens/operating/some_operation.h"
#include "ui/jobs/recording_quality.h"
#include "ui/screens/operating/operation_work.h"
#include "ui/screens/pictures/shown_camera.h"

namespace hallux::ui {
namespace {

using simulator::ToolSample;
using simulator::ToolStatus;

constexpr std::int64_t lost_tick = 300, found_tick = 900, end_tick = 1400;

/// Held still with the saw running; it does not answer for a while.
class LooseCable final : public simulator::HapticDevice {
 public:
  explicit LooseCable(const RigidTransform& world_from_handle) : pose_(world_from_handle) {}
  simulator::DeviceDescription description() const override { return {"Loose cable", "mouse"}; }
  bool exchange(const Vec3&, std::int64_t tick,
                simulator::RawDeviceState& state) noexcept override {
    if (tick >= lost_tick && tick < found_tick) return false;
    state = {pose_, static_cast<std::uint32_t>(simulator::Switch::SawRuns)};
    return true;
  }

 private:
  RigidTransform pose_;
};

/// Ada, about to operate.
class LiveAttempts : public testing::Test {
 protected:
  LiveAttempts() {
    what_.scenario = course_.version();
    what_.person = signed_in_->person().id;
  }

  OperableCourse course_{"silver"};
  const std::shared_ptr<SignedInSession> signed_in_ = course_.visit_of_ada();
  const std::shared_ptr<const PreparedCase> prepared_case_ = course_.prepared_case(*signed_in_);
  LiveBegin what_;
};

TEST_F(LiveAttempts, ADeviceThatDoesNotAnswerStopsTheSawAndIsOnTheRecord) {
  const std::unique_ptr<LiveAttempt> live =
      begin_operation(*signed_in_, prepared_case_, what_,
                      std::make_unique<LooseCable>(start_pose(*prepared_case_)));
  bool was_said = false;
  ASSERT_TRUE(soon([&] {
    const simulator::LoopView& view = live->view();
    was_said = was_said || has(view.sample.status, ToolStatus::Faulted);
    return view.sample.tick > end_tick;
  }));
  EXPECT_TRUE(was_said);
  live->finish();
  ASSERT_TRUE(soon([&] { return live->end() != nullptr; }));
  EXPECT_TRUE(live->end()->is_sealed);
  EXPECT_EQ(live->end()->failure, LiveFailure::None);

  const simulator::Recording kept = course_.course().trainee("ada").recording(live->attempt());
  for (const ToolSample& sample : kept.samples) {
    const bool is_lost = sample.tick >= lost_tick + 3 && sample.tick < found_tick - 3;
    const bool is_there =
        sample.tick > 20 && (sample.tick < lost_tick - 3 || sample.tick > found_tick + 20);
    if (is_lost) {
      ASSERT_TRUE(has(sample.status, ToolStatus::Faulted)) << sample.tick;
      ASSERT_FALSE(has(sample.status, ToolStatus::SawOn)) << sample.tick;
    }
    if (is_there) {
      ASSERT_FALSE(has(sample.status, ToolStatus::Faulted)) << sample.tick;
    }
  }
}

TEST_F(LiveAttempts, ThatIsGuidedIsKeptAsOneAndReplaysBitForBit) {
  what_.guidance = simulator::Guidance::Slot;
  RigidTransform beside = start_pose(*prepared_case_);
  beside.translation_mm += Vec3(20.0, 20.0, 20.0);
  const std::unique_ptr<LiveAttempt> live =
      begin_operation(*signed_in_, prepared_case_, what_, std::make_unique<LooseCable>(beside));
  ASSERT_TRUE(soon([&] { return live->view().sample.tick > end_tick; }));
  live->finish();
  ASSERT_TRUE(soon([&] { return live->end() != nullptr; }));
  EXPECT_EQ(course_.attempt().begun.guidance, simulator::Guidance::Slot);

  database::TraineeDesk desk = course_.course().trainee("ada");
  AttemptMaterial material = load_attempt(course_.course().database(), desk, live->attempt());
  EXPECT_TRUE(replay_attempt(material, no_progress)->is_identical);
  material.header.begun.guidance = simulator::Guidance::None;
  EXPECT_FALSE(replay_attempt(material, no_progress)->is_identical);
}

TEST_F(LiveAttempts, APracticeMayLetAnArmFeelTheHistoricLaw) {
  what_.force_law = simulator::ForceLaw::Thesis;
  const std::unique_ptr<LiveAttempt> live =
      begin_operation(*signed_in_, prepared_case_, what_,
                      std::make_unique<LooseCable>(start_pose(*prepared_case_)));
  ASSERT_TRUE(soon([&] { return live->view().lines > 0; }));
  live->finish();
  ASSERT_TRUE(soon([&] { return live->end() != nullptr; }));
  EXPECT_EQ(quality_from_json(course_.attempt().quality_json)->force_law,
            simulator::ForceLaw::Thesis);
}

TEST_F(LiveAttempts, KeepWhatWasOnTheScreen) {
  const std::unique_ptr<LiveAttempt> live =
      begin_operation(*signed_in_, prepared_case_, what_,
                      std::make_unique<LooseCable>(start_pose(*prepared_case_)));
  ASSERT_TRUE(soon([&] { return live->view().lines > 0; }));
  Camera camera = start_camera(*prepared_case_);
  simulator::ShownView last;
  ASSERT_TRUE(soon([&] {
    camera = orbited(camera, 0.05, 0.0);
    last = shown_view(camera, 1.6);
    const std::int64_t tick = live->view().sample.tick;
    live->note_view(last, tick);
    return tick > lost_tick;
  }));
  live->finish();
  ASSERT_TRUE(soon([&] { return live->end() != nullptr; }));
  const auto facts = course_.course().trainee("ada").display_facts(live->attempt());
  ASSERT_GE(facts.size(), 2U);
  EXPECT_EQ(live->end()->recorder.display_facts, static_cast<std::int64_t>(facts.size()));
  for (const simulator::DisplayFact& fact : facts) EXPECT_TRUE(is_view(fact) && is_known(fact));
  EXPECT_TRUE(is_noticeably_other(shown_view_of(facts.front()), shown_view_of(facts.back())));
}

TEST_F(LiveAttempts, OfAnAssessmentIsNotBegunWithAGuide) {
  what_.kind = database::AttemptKind::Assessment;
  what_.guidance = simulator::Guidance::Soft;
  try {
    begin_operation(*signed_in_, prepared_case_, what_,
                    std::make_unique<LooseCable>(start_pose(*prepared_case_)));
    ADD_FAILURE() << "was begun";
  } catch (const database::DatabaseError& error) {
    EXPECT_EQ(error.kind(), database::DatabaseErrorKind::BadInput);
  }
  EXPECT_TRUE(course_.course().trainee("ada").attempts().empty());
}

}  // namespace
}  // namespace hallux::ui
