// What would have earned more, on the result.
#include "ui/screens/result/what_if_card.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <nlohmann/json.hpp>

#include "tests/ui/screens/result/some_reader.h"

namespace hallux::ui {
namespace {

using database::SomeCourse;
using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* title = "What would have earned more";

/// In a window that shows the whole page.
struct TallReader : Reader {
  TallReader(SomeCourse& course, const std::string& login, const database::AttemptId& attempt)
      : Reader(course, login, attempt) {
    driver().resize(1600.0F, 2000.0F);
    finish();
  }
};

/// Ada's Akin without the gates that cap it, so that changes gain.
SomeOperation ungated() {
  SomeOperation operation = some_operation();
  nlohmann::json scenario = nlohmann::json::parse(operation.scenario.text);
  scenario["rubric"]["gates"] = nlohmann::json::array();
  operation.scenario = scenarios::parse_scenario(scenario.dump(2), "akin");
  return operation;
}

struct UngatedCourse {
  SomeCourse course;
  database::AttemptId attempt = operated_by(course, "ada", ungated());
};

TEST(WhatIfCard, SaysWhatWouldHaveEarnedMoreAndLeadsToItsMoment) {
  UngatedCourse akin;
  TallReader by_mouse(akin.course, "ada", akin.attempt);
  Driver& driver = by_mouse.driver();
  for (const char* words : {title, "turned back by", "More points for: ", "All three together",
                            "would have been", "Worked out by the scorer itself"})
    EXPECT_TRUE(driver.sees(words)) << words;
  EXPECT_FALSE(driver.sees("Working out"));
  driver.click("result.what_if.0.action");
  Reader by_keyboard(akin.course, "ada", akin.attempt);
  by_keyboard.tab_to("result.what_if.0.action");
  by_keyboard.driver().press(Key::Enter);
  ASSERT_THAT(by_mouse.asked(), SizeIs(1));
  EXPECT_THAT(by_mouse.asked(), Each(HasSubstr("replay " + akin.attempt.text)));
  EXPECT_EQ(by_keyboard.asked(), by_mouse.asked());
}

TEST(WhatIfCard, IsWholeAtAnyScaleInANarrowAndAWideWindow) {
  UngatedCourse akin;
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Reader reader(akin.course, "ada", akin.attempt, scale);
    for (const float width : {1280.0F, 1920.0F, 3840.0F}) {
      reader.driver().resize(width, 6000.0F);
      reader.finish();
      EXPECT_TRUE(reader.driver().sees("All three together")) << width << " at " << scale;
      EXPECT_THAT(reader.driver().faults(), IsEmpty()) << width << " at " << scale;
    }
  }
}

TEST(WhatIfCard, SaysThatAGateLeavesNothingToGain) {
  OperatedCourse akin;
  TallReader reader(akin.course, "ada", akin.attempt);
  EXPECT_TRUE(reader.driver().sees("A gate caps this score"));
  EXPECT_FALSE(reader.driver().has("result.what_if.0.action"));
  EXPECT_THAT(reader.driver().faults(), IsEmpty());
}

TEST(WhatIfCard, IsOnlyThereBesideTheScoreThatIsShown) {
  OperatedCourse akin;
  database::ScoreCard older = akin.course.trainee("ada").score(akin.attempt)->card;
  older.score_milli = 12'300;
  store_score(akin.course.database(), akin.attempt, older, akin.course.id_of("ada"));
  TallReader differs(akin.course, "ada", akin.attempt);
  EXPECT_TRUE(differs.driver().sees("Computed again now"));
  EXPECT_FALSE(differs.driver().sees(title));
  SomeCourse lost;
  TallReader unreadable(lost, "ada", lost.scored_by("ada", 76'830));
  EXPECT_TRUE(unreadable.driver().sees("76.8"));
  EXPECT_FALSE(unreadable.driver().sees(title)) << "the bone cannot be computed";
}

/// Nothing but the card, until it is left.
struct CardAlone : Screen {
  CardAlone(std::shared_ptr<SignedInSession> by, database::AttemptId about)
      : signed_in(std::move(by)), attempt(std::move(about)) {}
  GuideSection guide_section() const override { return GuideSection::Result; }
  void draw(Ui& ui, const Rect&, Shell& shell) override {
    card.work_out(ui, shell, signed_in, attempt);
  }

  WhatIfCard card;
  std::shared_ptr<SignedInSession> signed_in;
  database::AttemptId attempt;
};

struct NothingThere : Screen {
  GuideSection guide_section() const override { return GuideSection::Result; }
  void draw(Ui&, const Rect&, Shell&) override {}
};

TEST(WhatIfCard, WhatIsBeingWorkedOutStopsWhenItsScreenIsLeft) {
  UngatedCourse akin;
  std::promise<void> ended;
  Shell shell([&] { ended.set_value(); });
  const Texts texts = english_texts();
  Driver driver(texts, [&](Ui& ui) { shell.draw(ui); });
  shell.push(std::make_unique<CardAlone>(visit_of(akin.course, "ada"), akin.attempt));
  driver.frame();
  driver.frame();
  ASSERT_THAT(shell.background().running(), SizeIs(1));
  shell.replace_all(std::make_unique<NothingThere>());
  driver.frame();
  ASSERT_EQ(ended.get_future().wait_for(std::chrono::minutes(1)), std::future_status::ready);
  ASSERT_THAT(shell.background().running(), SizeIs(1)) << "nobody has looked since it ended";
  EXPECT_LT(shell.background().running().front().share, 1.0) << "it went on to its end";
}

}  // namespace
}  // namespace hallux::ui
