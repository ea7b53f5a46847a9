#include "ui/screens/replay/replay_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"
#include "tests/ui/screens/some_reviewer.h"
#include "ui/screens/pictures/shown_camera.h"

namespace hallux::ui {
namespace {

using database::AttemptId;
using database::SomeCourse;
using testing::IsEmpty;
using testing::SizeIs;

/// Somebody of the course who watches an attempt from a moment on.
struct Watcher : SomeReviewer {
  Watcher(SomeCourse& course, const std::string& login, const AttemptId& attempt,
          double moment_s = 0.0, float scale = 1.0F, ScenePainter* painter = nullptr)
      : SomeReviewer(
            [&](SomeNavigator&) {
              return std::make_unique<ReplayScreen>(visit_of(course, login), attempt, moment_s);
            },
            scale, painter) {}
  void press_bone() {
    const Rect view = driver().widget("replay.view").rect;
    const Point middle{view.mid_x() * driver().ui().scale(), view.mid_y() * driver().ui().scale()};
    driver().send(click_events(middle));
    driver().settle();
  }
};

/// The moment that the clock beside the buttons says; the axis says others.
std::string moment_of(const Driver& driver) {
  const Rect buttons = driver.widget("replay.play").rect;
  const SeenText* clock = nullptr;
  for (const SeenText& text : driver.content().texts) {
    const bool is_beside = text.rect.mid_y() > buttons.y && text.rect.mid_y() < buttons.bottom() &&
                           text.rect.x > buttons.right();
    if (is_beside && (clock == nullptr || text.rect.x < clock->rect.x)) clock = &text;
  }
  return clock == nullptr ? "" : clock->text;
}

/// Notes from where a picture was drawn.
class NotedCamera : public NoScenePainter {
 public:
  std::uint64_t draw(std::string_view name, const Scene& scene, const Camera& seen_from,
                     PixelSize size) override {
    camera = seen_from;
    return NoScenePainter::draw(name, scene, seen_from, size);
  }
  Camera camera;
};

/// Seen from medial until 0.3 s, then turned for two tenths of a second to from plantar.
std::vector<simulator::DisplayFact> seen_by_ada() {
  Camera camera;
  camera.target_mm = Vec3(12.0, 3.0, -4.0);
  camera.magnification = 9.0;
  const Camera medial = standard_view(camera, StandardView::Medial);
  std::vector<simulator::DisplayFact> facts{*fact_of(shown_view(medial, 1.6), 10)};
  for (const std::int64_t tick : {300, 400, 500}) {
    Camera turned = standard_view(medial, StandardView::Plantar);
    turned.world_from_view = glm::slerp(medial.world_from_view, turned.world_from_view,
                                        0.005 * static_cast<double>(tick - 300));
    facts.push_back(*fact_of(shown_view(turned, 1.6), tick));
  }
  return facts;
}

/// The same attempt with what ada saw.
struct SeenCourse {
  database::SomeCourse course;
  SomeOperation operation = some_operation();
  database::AttemptId attempt = operated_by(course, "ada", operation, true, seen_by_ada());
};

double degree_between(const Camera& a, const Quat& b) {
  const double cosine = std::min(1.0, std::abs(glm::dot(a.world_from_view, b)));
  return degree_from_radian(2.0 * std::acos(cosine));
}
double degree_from(const Camera& a, StandardView view) {
  return degree_between(a, standard_view(a, view).world_from_view);
}

TEST(ReplayScreen, OpensWithTheViewThatWasOnTheScreenAtThatMoment) {
  SeenCourse akin;
  {
    NotedCamera noted;
    Watcher watcher(akin.course, "ada", akin.attempt, 0.0, 1.0F, &noted);
    EXPECT_LT(degree_from(noted.camera, StandardView::Medial), 0.1);
    EXPECT_NEAR(noted.camera.target_mm.x, 12.0, 0.01);
    EXPECT_TRUE(watcher.driver().sees("As it was on the screen"));
    EXPECT_THAT(watcher.driver().faults(), IsEmpty());
  }
  NotedCamera noted;
  Watcher kim(akin.course, "kim", akin.attempt, 0.6, 1.0F, &noted);
  EXPECT_LT(degree_from(noted.camera, StandardView::Plantar), 0.1) << "for whoever watches it";
}

bool shows_section(Watcher& watcher) {
  for (int frame = 0; frame < 400; ++frame) {
    watcher.driver().frame();
    const std::vector<ReadOut>& told = watcher.driver().content().read_outs;
    if (std::ranges::any_of(told, [](const ReadOut& each) { return each.id == "replay.section"; }))
      return true;
  }
  return false;
}

TEST(ReplayScreen, HasTheSectionBesideItWhereItStoodBesideTheOperation) {
  SomeCourse course;
  SomeOperation operation = some_operation();
  std::vector<simulator::DisplayFact> facts = seen_by_ada();
  facts.back().layout = simulator::ShownLayout::WithSection;
  const AttemptId attempt = operated_by(course, "ada", operation, true, facts);
  Watcher early(course, "ada", attempt, 0.1), late(course, "ada", attempt, 0.6);
  EXPECT_FALSE(shows_section(early));
  EXPECT_TRUE(early.driver().sees("As it was on the screen"));
  EXPECT_FALSE(early.driver().sees("where the section stood beside it"));
  EXPECT_TRUE(shows_section(late));
  EXPECT_TRUE(late.driver().sees("where the section stood beside it"));
  EXPECT_THAT(late.driver().faults(), IsEmpty());
}

TEST(ReplayScreen, TheViewMovesAsThePersonTurnedIt) {
  SeenCourse akin;
  NotedCamera noted;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.29, 1.0F, &noted);
  Driver& driver = watcher.driver();
  for (int slower = 0; slower < 3; ++slower) driver.press(Key::LeftBracket);
  driver.send(key_events(Key::Space));
  double from_medial = 0.0;
  for (int frame = 0; frame < 150; ++frame) {  // a quarter of a second at a tenth of the speed
    driver.frame();
    const double now = degree_from(noted.camera, StandardView::Medial);
    EXPECT_GE(now, from_medial - 1.0e-6);
    EXPECT_LT(now, from_medial + 3.0) << "it does not jump";
    from_medial = now;
  }
  EXPECT_LT(degree_from(noted.camera, StandardView::Plantar), 0.1);
}

TEST(ReplayScreen, OfAnOlderAttemptShowsTheOperatorsViewAndSaysSo) {
  OperatedCourse akin;
  NotedCamera noted;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.2, 1.0F, &noted);
  EXPECT_LT(degree_from(noted.camera, StandardView::Operator), 0.1);
  EXPECT_TRUE(watcher.driver().sees("was not recorded: the operator's view"));
}

TEST(ReplayScreen, AViewThatIsHostileOrUnknownIsTheOperatorsAndSaysSo) {
  SeenCourse akin;
  for (const char* what : {"layout = 77",
                           "layout = 0, rotation_w_micro = 0, rotation_x_micro = 0, "
                           "rotation_y_micro = 0, rotation_z_micro = 0"}) {
    database::tamper(
        akin.course.database(),
        "PRAGMA ignore_check_constraints = ON; UPDATE display_fact SET " + std::string(what));
    NotedCamera noted;
    Watcher watcher(akin.course, "ada", akin.attempt, 0.2, 1.0F, &noted);
    EXPECT_LT(degree_from(noted.camera, StandardView::Operator), 0.1) << what;
    EXPECT_TRUE(watcher.driver().sees("cannot be shown: the operator's view")) << what;
    EXPECT_THAT(watcher.driver().faults(), IsEmpty());
  }
}

TEST(ReplayScreen, WhoTurnsTheViewByHandComesBackToWhatWasSeen) {
  SeenCourse akin;
  NotedCamera noted;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.2, 1.0F, &noted);
  Driver& driver = watcher.driver();
  driver.press(Key::Left, {.alt = true});
  const Quat by_hand = noted.camera.world_from_view;
  EXPECT_GT(degree_from(noted.camera, StandardView::Medial), 5.0);
  EXPECT_FALSE(driver.sees("As it was on the screen"));
  driver.press(Key::End);
  EXPECT_LT(degree_between(noted.camera, by_hand), 0.1) << "the hand's view stays over time";
  driver.press(Key::R);
  EXPECT_LT(degree_from(noted.camera, StandardView::Plantar), 0.1);
  EXPECT_TRUE(driver.sees("As it was on the screen"));
  driver.click("replay.views.1");
  EXPECT_LT(degree_from(noted.camera, StandardView::Dorsal), 0.1);
  driver.click("replay.views.0");
  EXPECT_LT(degree_from(noted.camera, StandardView::Plantar), 0.1);
}

TEST(ReplayScreen, BeginsAtTheMomentThatWasAskedFor) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.42);
  EXPECT_EQ(moment_of(watcher.driver()), "00:00.4");
  EXPECT_TRUE(watcher.driver().sees("Akin osteotomy, right hallux / Attempt 1"));
  EXPECT_TRUE(watcher.driver().sees("Not surgeon-reviewed"));
  EXPECT_THAT(watcher.driver().faults(), IsEmpty());
}

TEST(ReplayScreen, AnEventIsLookedAtByItsRow) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt);
  Driver& driver = watcher.driver();
  driver.click("replay.tab.2");
  EXPECT_TRUE(driver.sees("A piece was taken out"));
  driver.click("replay.event.2");  // the first blade entered, at 10 ms
  EXPECT_TRUE(driver.sees("The blade entered the bone"));
  driver.press(Key::N);
  EXPECT_EQ(moment_of(driver), "00:00.3") << "the first cut was declared done";
}

TEST(ReplayScreen, ALedgerEntryIsLookedAtByKeyboard) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.4);
  Driver& driver = watcher.driver();
  watcher.tab_to("replay.tab");
  driver.press(Key::Right);
  driver.press(Key::Space);
  watcher.tab_to("replay.ledger");
  EXPECT_EQ(moment_of(driver), "00:00.4");
  driver.press(Key::Enter);
  EXPECT_NE(moment_of(driver), "00:00.4");
}

TEST(ReplayScreen, ANoteIsPinnedToMomentAndBoneAndAnswered) {
  OperatedCourse akin;
  {
    Watcher instructor(akin.course, "kim", akin.attempt, 0.2);
    instructor.press_bone();
    instructor.driver().click("replay.pin");
    EXPECT_TRUE(instructor.driver().sees("at the place that you marked"));
    instructor.driver().type("Look along the blade.");
    instructor.driver().click("pin.act");
    instructor.finish();
    EXPECT_TRUE(instructor.driver().sees("Look along the blade."));
    EXPECT_TRUE(instructor.driver().sees("The note is pinned"));
    EXPECT_THAT(instructor.driver().faults(), IsEmpty());
  }
  const auto notes = akin.course.trainee("ada").notes(akin.attempt);
  ASSERT_THAT(notes, SizeIs(1));
  EXPECT_EQ(notes.front().moment.moment_us, 200'000);
  ASSERT_TRUE(notes.front().moment.place.has_value());
  {
    // The trainee answers with the keyboard alone.
    Watcher trainee(akin.course, "ada", akin.attempt);
    Driver& driver = trainee.driver();
    EXPECT_FALSE(driver.has("replay.pin"));
    trainee.tab_to("notes.note.1");
    driver.press(Key::Space);
    EXPECT_EQ(moment_of(driver), "00:00.2") << "the note's moment";
    trainee.tab_to("notes.reply");
    driver.type("Now I see it.");
    driver.press(Key::Enter);
    trainee.finish();
    EXPECT_TRUE(driver.sees("Now I see it."));
    EXPECT_THAT(driver.faults(), IsEmpty());
  }
  ASSERT_THAT(akin.course.trainee("ada").notes(akin.attempt).front().replies, SizeIs(1));
}

TEST(ReplayScreen, APlaceOnTheBoneIsOnItsSkin) {
  OperatedCourse akin;
  Watcher instructor(akin.course, "kim", akin.attempt);
  instructor.driver().press(Key::M);  // no mouse: what is in the middle
  instructor.driver().press(Key::C);
  instructor.driver().type("Here.");
  instructor.driver().press(Key::Enter, {.control = true});
  instructor.finish();
  const auto notes = akin.course.trainee("ada").notes(akin.attempt);
  ASSERT_THAT(notes, SizeIs(1));
  ASSERT_TRUE(notes.front().moment.place.has_value());
  const auto& place = notes.front().moment.place->point_in_bone_mm;
  const simulator::Bvh skin(akin.operation.bone.outer);
  EXPECT_NEAR(skin.signed_distance_mm(Vec3(place[0], place[1], place[2])), 0.0, 1.0e-5);
}

TEST(ReplayScreen, TheBladeViewShowsWhatLiesInItsPlane) {
  OperatedCourse akin;
  // In the middle of the first cut.
  Watcher watcher(akin.course, "ada", akin.attempt, 0.1);
  EXPECT_FALSE(watcher.driver().sees(" mm ahead"));
  watcher.driver().click("replay.views.4");
  watcher.finish();
  EXPECT_TRUE(watcher.driver().sees(" mm ahead"));
  EXPECT_THAT(watcher.driver().faults(), IsEmpty());
  watcher.driver().click("replay.views.1");
  EXPECT_FALSE(watcher.driver().sees(" mm ahead"));
}

TEST(ReplayScreen, APrivateNoteIsNeverSeenByTheTrainee) {
  OperatedCourse akin;
  Watcher instructor(akin.course, "kim", akin.attempt);
  instructor.driver().press(Key::C);
  instructor.driver().type("Ask about the left hand.");
  instructor.driver().click("pin.toggle");
  instructor.driver().click("pin.act");
  instructor.finish();
  EXPECT_TRUE(instructor.driver().sees("Ask about the left hand."));
  EXPECT_TRUE(instructor.driver().sees("Private"));
  instructor.driver().click("notes.note.1");
  EXPECT_FALSE(instructor.driver().has("notes.reply")) << "a private note has no answers";
  Watcher trainee(akin.course, "ada", akin.attempt);
  EXPECT_FALSE(trainee.driver().sees("Ask about the left hand."));
  EXPECT_TRUE(trainee.driver().sees("No notes yet"));
}

TEST(ReplayScreen, ATraineeFlagsTheMomentByKeyboard) {
  OperatedCourse akin;
  Watcher trainee(akin.course, "ada", akin.attempt, 0.3);
  trainee.driver().press(Key::F);
  trainee.driver().type("Where should I look?");
  trainee.driver().press(Key::Enter, {.control = true});
  trainee.finish();
  const auto requests = akin.course.trainee("ada").help_requests();
  ASSERT_THAT(requests, SizeIs(1));
  EXPECT_EQ(requests.front().moment.moment_us, 300'000);
  EXPECT_FALSE(trainee.driver().has("ask.act"));
  EXPECT_TRUE(trainee.driver().sees("Where should I look?")) << "it stands there at once";
  EXPECT_TRUE(trainee.driver().sees("Question, open"));
  EXPECT_EQ(trainee.driver().widget("replay.timeline.note.1").label,
            "Where should I look?, 00:00.3");
  Watcher instructor(akin.course, "kim", akin.attempt);
  EXPECT_FALSE(instructor.driver().has("replay.flag")) << "an instructor answers, and asks nobody";
}

TEST(ReplayScreen, AQuestionStandsAmongTheNotesWithItsAnswer) {
  OperatedCourse akin;
  auto ada = akin.course.trainee("ada");
  auto kim = akin.course.instructor("kim", akin.course.autumn());
  const database::HelpRequestId asked =
      ada.ask_for_help({akin.attempt, {100'000}, "Is this deep enough?"});
  ada.ask_for_help({akin.attempt, {500'000}, "And here?"});
  kim.add_note({akin.attempt, {300'000}, false, "Look along the blade."});
  kim.answer(asked, "Two millimetres more.");
  // Of another attempt: it is not listed here.
  ada.ask_for_help({akin.course.recorded_by("ada"), {}, "Elsewhere?"});
  for (const char* login : {"ada", "kim"}) {
    Watcher watcher(akin.course, login, akin.attempt);
    Driver& driver = watcher.driver();
    for (const char* words : {"Is this deep enough?", "Question, answered", "Two millimetres more.",
                              "And here?", "Question, open"})
      EXPECT_TRUE(driver.sees(words)) << words << " for " << login;
    EXPECT_FALSE(driver.sees("Elsewhere?"));
    EXPECT_LT(driver.widget("notes.question.1").rect.y, driver.widget("notes.note.1").rect.y);
    EXPECT_LT(driver.widget("notes.note.1").rect.y, driver.widget("notes.question.2").rect.y);
    driver.click("notes.question.2");
    EXPECT_EQ(moment_of(driver), "00:00.5");
    EXPECT_FALSE(driver.has("notes.reply")) << "a question is answered in the inbox";
    driver.click("replay.tab.2");
    driver.click("replay.timeline.note.1");
    EXPECT_EQ(moment_of(driver), "00:00.1");
    EXPECT_TRUE(driver.widget("notes.question.1").is_chosen);
    EXPECT_THAT(driver.faults(), IsEmpty());
  }
}

TEST(ReplayScreen, ALongNoteHasNoBlankSpaceBelow) {
  OperatedCourse akin;
  std::string words;
  for (int i = 0; i < 40; ++i) words += "Look along the blade before the teeth touch the bone. ";
  auto kim = akin.course.instructor("kim", akin.course.autumn());
  kim.add_note({akin.attempt, {100'000}, false, words});
  kim.add_note({akin.attempt, {200'000}, false, "Short."});
  for (const float scale : {1.0F, 1.5F}) {
    Watcher watcher(akin.course, "ada", akin.attempt, 0.0, scale);
    Driver& driver = watcher.driver();
    driver.resize(1440.0F * scale, 2400.0F * scale);
    driver.settle();
    for (const char* id : {"notes.note.1", "notes.note.2"}) {
      const Rect row = driver.widget(id).rect;
      float lowest = row.y;
      for (const SeenText& text : driver.content().texts)
        if (row.encloses(text.rect, 1.0F)) lowest = std::max(lowest, text.rect.bottom());
      EXPECT_LT(row.bottom() - lowest, 24.0F) << id << " at " << scale;
    }
    driver.resize(1440.0F * scale, 900.0F * scale);
    driver.settle();
    const Rect list = driver.widget("notes.list").rect;
    driver.wheel({list.mid_x(), list.mid_y()}, -400.0F);
    const Widget& last = driver.widget("notes.note.2");
    EXPECT_EQ(last.visible, last.rect) << "the list ends with its last note, at " << scale;
  }
}

TEST(ReplayScreen, TheTimeZoomsByKeysAndTheViewStaysAsItIs) {
  OperatedCourse akin;
  NotedCamera noted;
  Watcher watcher(akin.course, "ada", akin.attempt, 0.3, 1.0F, &noted);
  Driver& driver = watcher.driver();
  const double before = noted.camera.magnification;
  EXPECT_TRUE(driver.sees("All of 00:00"));
  driver.press(Key::Plus);
  EXPECT_TRUE(driver.sees(" of 00:00"));
  EXPECT_FALSE(driver.sees("All of 00:00"));
  EXPECT_EQ(noted.camera.magnification, before);
  driver.press(Key::Plus, {.alt = true});
  EXPECT_GT(noted.camera.magnification, before);
  driver.press(Key::Digit0);
  EXPECT_TRUE(driver.sees("All of 00:00"));
}

TEST(ReplayScreen, ARefusedNoteStaysInItsForm) {
  OperatedCourse akin;
  Watcher instructor(akin.course, "kim", akin.attempt);
  instructor.driver().click("replay.pin");
  instructor.driver().type("Look here.");
  akin.course.administrator().remove_from_cohort(akin.course.autumn(), "kim");
  instructor.driver().click("pin.act");
  instructor.finish();
  EXPECT_TRUE(instructor.driver().sees("not yours to write"));
  EXPECT_TRUE(instructor.driver().sees("Look here."));
  EXPECT_THAT(instructor.driver().faults(), IsEmpty());
}

TEST(ReplayScreen, TheTimelineIsScrubbed) {
  OperatedCourse akin;
  Watcher watcher(akin.course, "ada", akin.attempt);
  Driver& driver = watcher.driver();
  const Rect line = driver.widget("replay.timeline").rect;
  driver.drag({line.x + 200.0F, line.mid_y()}, {line.right() - 4.0F, line.mid_y()});
  EXPECT_NE(moment_of(driver), "00:00.0");
  driver.press(Key::Home);
  EXPECT_EQ(moment_of(driver), "00:00.0");
}

TEST(ReplayScreen, AnAttemptThatCannotBeSeenSaysWhy) {
  OperatedCourse akin;
  Watcher other(akin.course, "bob", akin.attempt);
  EXPECT_TRUE(other.driver().sees("This could not be read"));
  EXPECT_FALSE(other.driver().sees("Akin"));
  Watcher unreadable(akin.course, "ada", akin.course.scored_by("ada", 50'000));
  EXPECT_TRUE(unreadable.driver().sees("This could not be read"));
  EXPECT_TRUE(unreadable.driver().has("replay.failed.action"));
}

TEST(ReplayScreen, NothingIsCutOffAtAnyScaleOrSize) {
  OperatedCourse akin;
  auto desk = akin.course.instructor("kim", akin.course.autumn());
  desk.add_note({akin.attempt,
                 {150'000, database::BonePoint{0, {6.0, 6.0, 0.0}}},
                 false,
                 "The blade touches before you have looked along it. Take one second here."});
  desk.add_note({akin.attempt, {400'000}, true, "Private words."});
  akin.course.trainee("ada").ask_for_help(
      {akin.attempt, {450'000}, "Was this too fast, or did I only hold it wrongly here?"});
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Watcher watcher(akin.course, "kim", akin.attempt, 0.1, scale);
    for (const auto& [width, height] :
         {std::pair{1440.0F * scale, 900.0F * scale}, {1280.0F, 720.0F}, {3840.0F, 2160.0F}}) {
      watcher.driver().resize(width, height);
      watcher.driver().settle();
      for (const char* tab : {"replay.tab.1", "replay.tab.2", "replay.tab.0"}) {
        watcher.driver().click(tab);
        EXPECT_THAT(watcher.driver().faults(), IsEmpty()) << tab << " at " << scale;
      }
    }
  }
}

}  // namespace
}  // namespace hallux::ui
