#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "database/recording/recordings.h"
#include "simulator/base/progress.h"
#include "tests/ui/screens/operating/some_operation.h"
#include "ui/screens/pictures/shown_camera.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;
using database::AttemptState;
using testing::ElementsAre;
using testing::IsEmpty;

/// Leads the saw on by a key whenever it has come to rest, as a person does: a sawing blade takes
/// its time, the more so on a machine that is busy, and must not be left a handbreadth behind.
class LeadingHand {
 public:
  explicit LeadingHand(Operator& person) : person_(&person) {}

  /// needs   a saw is shown
  void look() {
    const Vec3 place = person_->scenes.saw->world_from_tool.translation_mm;
    still_frames_ = glm::distance(place, last_place_) < at_rest_mm ? still_frames_ + 1 : 0;
    last_place_ = place;
    if (still_frames_ < frames_at_rest) return;
    still_frames_ = 0;
    person_->press(Key::Down);
  }

 private:
  static constexpr int frames_at_rest = 6;
  static constexpr double at_rest_mm = 0.001;

  Operator* person_;
  Vec3 last_place_{0.0};
  int still_frames_ = 0;
};

/// Dorsal approach, seen from medial: away from the person over the middle of the head, then down
/// to it, until enough of it is cut to be seen.
void saw_into_the_bone(Operator& person) {
  person.press(Key::Digit3);
  for (int step = 0; step < 7; ++step) person.press(Key::PageUp);
  person.press(Key::Space);
  LeadingHand hand(person);
  ASSERT_TRUE(person.until([&] {
    hand.look();
    return person.scenes.patch_triangles > 100;
  })) << "nothing was cut";
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(700);
  person.until([&] { return std::chrono::steady_clock::now() > end; });
}

void answer(Operator& person, std::string_view id) {
  ASSERT_TRUE(person.until([&] { return person.driver().has(id); }));
  person.click(id);
}

TEST(Operating, AMouseAttemptIsRecordedSealedAndScoredAsTheTrainees) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  saw_into_the_bone(person);
  person.press(Key::End);
  answer(person, "operate.ask_finish.act");
  ASSERT_TRUE(person.until([&] { return person.is_gone(); }, 120.0));

  const database::AttemptHeader header = course.attempt();
  EXPECT_THAT(person.navigator.asked, ElementsAre("result " + header.id.text));
  EXPECT_EQ(header.state, AttemptState::Closed);
  EXPECT_EQ(header.login, "ada");
  EXPECT_EQ(header.begun.hand, "");
  EXPECT_EQ(header.begun.device_class, "mouse");
  EXPECT_EQ(header.begun.pacing, "real_time");
  EXPECT_EQ(header.begun.kind, AttemptKind::Practice);
  EXPECT_TRUE(header.is_complete);
  EXPECT_TRUE(header.score_milli.has_value());
  const simulator::Recording recording = course.course().trainee("ada").recording(header.id);
  EXPECT_GT(recording.samples.size(), 200U);
  EXPECT_EQ(recording.samples.size(), recording.tape.size());
  EXPECT_EQ(recording.events.back().kind, simulator::CutEventKind::Finished);
}

TEST(Operating, WhatWasOperatedLiveReplaysBitForBit) {
  OperableCourse course("silver");
  {
    Operator person(course, AttemptKind::Practice);
    person.begin();
    saw_into_the_bone(person);
    person.press(Key::End);
    answer(person, "operate.ask_finish.act");
    ASSERT_TRUE(person.until([&] { return person.is_gone(); }, 120.0));
  }
  database::HouseDesk house(course.course().database());
  database::TraineeDesk desk = course.course().trainee("ada");
  const AttemptMaterial material =
      load_attempt(course.course().database(), desk, course.attempt().id);
  const auto silent = [](const std::string&) { return Progress(); };
  const std::optional<simulator::ReplayResult> again = replay_attempt(material, silent);
  ASSERT_TRUE(again.has_value());
  EXPECT_TRUE(again->is_identical) << again->difference;
}

TEST(Operating, PracticeShowsThePlaneAndHowTheBladeStandsToIt) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  EXPECT_EQ(person.scenes.planes, 1U);
  EXPECT_EQ(person.scenes.lines, 1U) << "the blade's own plane on the bone";
  EXPECT_TRUE(person.driver().sees("Tilt across"));
  person.press(Key::G);
  EXPECT_EQ(person.scenes.planes, 0U) << "the picture without the plane";
  EXPECT_TRUE(person.driver().sees("Tilt across")) << "the numbers stay";
  EXPECT_TRUE(person.driver().sees("Plan "));
}

TEST(Operating, AnAssessmentShowsNothingOfThePlan) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Assessment);
  person.begin();
  person.press(Key::G);
  EXPECT_EQ(person.scenes.planes, 0U);
  EXPECT_EQ(person.scenes.lines, 0U)
      << "where the blade would come through the bone, no surgeon sees drawn on it";
  EXPECT_FALSE(person.driver().sees("Tilt across"));
  EXPECT_FALSE(person.driver().sees("Bone "));
  EXPECT_TRUE(person.driver().sees("Assessment"));
  EXPECT_TRUE(person.driver().sees("Push force"));
  EXPECT_EQ(course.attempt().begun.kind, AttemptKind::Assessment);
}

TEST(Operating, PracticeTellsHowHotTheBoneIs) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  EXPECT_TRUE(person.driver().sees("Bone 37 °C"));
  saw_into_the_bone(person);
  // A saw that is led no further warms nothing, and what it warmed may be cool again before anybody
  // looks.
  LeadingHand hand(person);
  EXPECT_TRUE(person.until([&] {
    hand.look();
    return !person.driver().sees("Bone 37 °C");
  }));
  EXPECT_TRUE(person.driver().sees("Bone ")) << "a dry saw warms it";
}

TEST(Operating, PlanAndTiltStayWhileTheSawIsInTheCutThatWasDeclaredDone) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  person.press(Key::Enter);
  saw_into_the_bone(person);
  person.press(Key::Enter);
  answer(person, "operate.ask_unfinished.act");
  ASSERT_TRUE(person.until([&] { return person.driver().has("operate.step.2"); }));
  EXPECT_TRUE(person.driver().sees("Tilt across")) << "the blade is still in it";
  EXPECT_EQ(person.scenes.planes, 1U);
  ASSERT_TRUE(person.until([&] {
    person.press(Key::PageDown);
    return !person.driver().sees("Tilt across");
  })) << "drawn out, the step at hand has no plan";
  EXPECT_EQ(person.scenes.planes, 0U);
}

TEST(Operating, NumbersAndBackspaceTakeStepsUpAgain) {
  OperableCourse course("silver");
  {
    Operator person(course, AttemptKind::Assessment);
    person.begin();
    const auto is_taken_up = [&] { return !person.driver().has("operate.step.1"); };
    person.press(Key::Enter);
    ASSERT_TRUE(person.until([&] { return !is_taken_up(); }));
    person.click("operate.step.1");
    EXPECT_TRUE(person.until(is_taken_up));
    person.click("operate.step");
    ASSERT_TRUE(person.until([&] { return !is_taken_up(); }));
    person.press(Key::Backspace);
    EXPECT_TRUE(person.until(is_taken_up));
    person.make_frames(20);
  }
  std::vector<std::string> told;
  const database::AttemptId id = course.attempt().id;
  for (const simulator::CutEvent& event : course.course().trainee("ada").recording(id).events) {
    if (event.kind == simulator::CutEventKind::StepDone)
      told.push_back("done " + std::to_string(event.subject));
    if (event.kind == simulator::CutEventKind::StepReopened)
      told.push_back("reopened " + std::to_string(event.subject));
  }
  EXPECT_THAT(told, ElementsAre("done 0", "reopened 0", "done 0", "reopened 0"));
}

TEST(Operating, ItCannotBeLeftWhileItIsRecorded) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  EXPECT_TRUE(person.shell().top()->why_not_leave().empty()) << "nothing is recorded yet";
  person.begin();
  EXPECT_FALSE(person.shell().top()->why_not_leave().empty());
  EXPECT_FALSE(person.shell().may_leave(person.driver().ui())) << "it asks first";
  answer(person, "operate.ask_leave.keep");
  person.make_frames(2);
  ASSERT_EQ(person.driver().ui().captured_by(), "operate.view");
  person.press(Key::Escape);
  EXPECT_FALSE(person.is_gone());
  EXPECT_TRUE(person.driver().sees("Paused"));
  EXPECT_EQ(person.driver().ui().captured_by(), "") << "Escape frees the pointer";
}

TEST(Operating, AnAbandonedAttemptIsKeptAsInterruptedAndNotScored) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  person.make_frames(20);
  person.click("operate.abandon");
  answer(person, "operate.ask_abandon.keep");
  EXPECT_FALSE(person.is_gone());
  person.click("operate.abandon");
  answer(person, "operate.ask_abandon.act");
  ASSERT_TRUE(person.until([&] { return person.is_gone(); }));
  EXPECT_THAT(person.navigator.asked, IsEmpty());
  const database::AttemptHeader header = course.attempt();
  EXPECT_EQ(header.state, AttemptState::Interrupted);
  EXPECT_FALSE(header.score_milli.has_value());
}

TEST(Operating, AWindowClosedInTheMiddleLosesNothing) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  saw_into_the_bone(person);
  const Camera seen_last = person.scenes.camera;
  person.close();
  const database::AttemptHeader header = course.attempt();
  EXPECT_EQ(header.state, AttemptState::Interrupted);
  const simulator::Recording recording = course.course().trainee("ada").recording(header.id);
  EXPECT_GT(recording.samples.size(), 200U);
  EXPECT_EQ(recording.samples.size(), recording.tape.size());
  // What was on the screen is kept, too: at last the view from medial.
  const auto facts = course.course().trainee("ada").display_facts(header.id);
  ASSERT_FALSE(facts.empty());
  const Camera kept = camera_of(shown_view_of(facts.back()), 1440.0 / 900.0);
  EXPECT_NEAR(std::abs(glm::dot(kept.world_from_view, seen_last.world_from_view)), 1.0, 1.0e-4);
  EXPECT_NEAR(kept.magnification, seen_last.magnification, 0.02 * seen_last.magnification);
}

TEST(Operating, WhetherTheSectionStoodBesideThePictureIsKept) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  const auto has_inset = [&] { return person.driver().has("operate.panel.inset"); };
  ASSERT_TRUE(person.until(has_inset));
  // Ten facts a second at most are kept.
  const auto let_time_pass = [&] {
    const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
    person.until([&] { return std::chrono::steady_clock::now() > end; });
  };
  let_time_pass();
  person.press(Key::V);
  EXPECT_FALSE(has_inset());
  let_time_pass();
  person.close();
  const auto facts = course.course().trainee("ada").display_facts(course.attempt().id);
  ASSERT_GE(facts.size(), 2U);
  EXPECT_EQ(facts.back().layout, simulator::ShownLayout::Whole);
  EXPECT_EQ(facts[facts.size() - 2].layout, simulator::ShownLayout::WithSection);
}

TEST(Operating, APauseHoldsTheClockOfTheSawAndThePicture) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  person.press(Key::P);
  EXPECT_TRUE(person.driver().sees("Paused"));
  person.make_frames(5);
  ASSERT_TRUE(person.until([&] { return std::isinf(person.driver().ui().next_frame_in_s()); }))
      << "a paused operation draws nothing of its own accord";
  person.press(Key::P);
  EXPECT_FALSE(person.driver().sees("The saw is off"));
  EXPECT_EQ(person.driver().ui().next_frame_in_s(), 0.0);
}

TEST(Operating, KeysChooseViewsAndEyes) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  const Camera before = person.scenes.camera;
  person.press(Key::Digit2);
  EXPECT_NE(person.scenes.camera.world_from_view, before.world_from_view);
  person.press(Key::R);
  EXPECT_EQ(person.scenes.camera.world_from_view, before.world_from_view);
  person.press(Key::F9);
  EXPECT_EQ(person.scenes.stereo.mode, StereoMode::SideBySide);
  person.press(Key::F9);
  EXPECT_EQ(person.scenes.stereo.mode, StereoMode::Anaglyph);
  person.press(Key::F9, {.shift = true});
  EXPECT_TRUE(person.scenes.stereo.is_swapped);
  person.press(Key::F9);
  EXPECT_EQ(person.scenes.stereo.mode, StereoMode::Mono);
}

TEST(Operating, AKeyThatIsHeldLeadsOnAndEndsWithItAndTurnsNothingOnAndOffAgain) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  const auto hold = [&](Key key, int repeats) {
    InputEvent event;
    event.kind = EventKind::KeyPressed;
    event.key = key;
    std::vector<InputEvent> events(static_cast<std::size_t>(repeats), event);
    event.kind = EventKind::KeyReleased;
    events.push_back(event);
    person.driver().send(events);
    person.make_frames(3);
  };
  const auto is_there = [&](const Vec3& place_mm) {
    return glm::length(person.scenes.saw->world_from_tool.translation_mm - place_mm) < 0.1;
  };
  // Away from the bone, along the blade.
  const RigidTransform& begun = person.scenes.saw->world_from_tool;
  const Vec3 wanted_mm = begun.translation_mm - 12.0 * axis_x(begun);
  hold(Key::PageDown, 12);
  EXPECT_TRUE(person.until([&] { return is_there(wanted_mm); }))
      << "twelve repeats that waited for three slow frames are twelve millimetres";
  for (int repeat = 0; repeat < 5; ++repeat) {
    InputEvent event;
    event.kind = EventKind::KeyPressed;
    event.key = Key::Space;
    person.driver().send({event});
    person.make_frames(3);
  }
  EXPECT_TRUE(person.until([&] { return person.scenes.saw->is_running; }, 2.0));
  hold(Key::Space, 1);
  EXPECT_TRUE(person.scenes.saw->is_running) << "that was the end of the same press";
  hold(Key::Space, 4);
  EXPECT_TRUE(person.until([&] { return !person.scenes.saw->is_running; }, 2.0));
}

TEST(Operating, HHidesThePanels) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  person.press(Key::H);
  EXPECT_FALSE(person.driver().sees("Push force"));
  person.press(Key::H);
  EXPECT_TRUE(person.driver().sees("Push force"));
}

TEST(Operating, MTurnsTheSoundOfTheSawOnAndOffForAllOperationsOfTheWindow) {
  ::setenv("ALSOFT_DRIVERS", "null", 1);
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  ASSERT_FALSE(person.shell().preferences().is_saw_heard);
  person.press(Key::M);
  EXPECT_TRUE(person.shell().preferences().is_saw_heard);
  person.press(Key::Space);
  EXPECT_TRUE(person.until([&] { return person.scenes.saw->is_running; }, 5.0));
  person.make_frames(5);
  person.press(Key::M);
  EXPECT_FALSE(person.shell().preferences().is_saw_heard);
  person.press(Key::F1);
  EXPECT_TRUE(person.driver().sees("Sound of the saw"));
}

TEST(Operating, StepsAreDeclaredByEnterAndAPieceThatIsNotFreeIsNotTaken) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  EXPECT_TRUE(person.driver().sees("Verify the case"));
  person.press(Key::Enter);
  EXPECT_TRUE(person.driver().sees("Cut the eminence"));
  person.press(Key::Enter);
  answer(person, "operate.ask_unfinished.act");
  EXPECT_TRUE(person.driver().sees("Take it out"));
  EXPECT_FALSE(person.driver().widget("operate.step").is_enabled);
  EXPECT_TRUE(person.until([&] { return person.driver().sees("the cut was not begun"); })) << "why";
}

TEST(Operating, NothingIsCutOffAtAnyScale) {
  OperableCourse course("akin");
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    // Of one window: the larger the scale, the less room there is.
    Operator person(course, AttemptKind::Practice, scale, {1280.0F / scale, 720.0F / scale});
    EXPECT_THAT(person.driver().faults(), IsEmpty()) << scale;
    person.begin();
    person.click("operate.health");
    EXPECT_TRUE(person.driver().sees("Ticks missed"));
    EXPECT_THAT(person.driver().faults(), IsEmpty()) << scale;
    person.click("operate.health");
    person.press(Key::L);
    person.press(Key::Space);
    EXPECT_TRUE(person.until([&] { return person.driver().sees("/min"); })) << scale;
    EXPECT_THAT(person.driver().faults(), IsEmpty()) << scale;
    EXPECT_EQ(person.driver().has("operate.panel.plan"), scale < 1.9F);
    person.press(Key::End);
    EXPECT_THAT(person.driver().faults(), IsEmpty()) << scale;
  }
}

TEST(Operating, AScenarioThatIsNotPublishedIsSaidAndNothingIsStored) {
  OperableCourse course("silver");
  course.course().administrator().retire_scenario(course.version());
  Operator person(course, AttemptKind::Practice);
  person.press(Key::Enter);
  ASSERT_TRUE(person.until([&] { return person.driver().sees("The operation stopped"); }));
  EXPECT_TRUE(person.driver().sees("not published"));
  EXPECT_THAT(person.driver().faults(), IsEmpty());
  EXPECT_TRUE(database::list_attempts(course.course().database()).empty());
  person.press(Key::Escape);
  EXPECT_TRUE(person.until([&] { return person.is_gone(); }));
}

}  // namespace
}  // namespace hallux::ui
