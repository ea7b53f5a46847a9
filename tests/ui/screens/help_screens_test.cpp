// Questions about a moment: the inbox of those who teach, and the own questions of those who ask.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/screens/every_size.h"
#include "tests/ui/screens/some_navigator.h"
#include "ui/screens/instructor/inbox_screen.h"
#include "ui/screens/trainee/questions_screen.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// ada, bob and eve each ask about an attempt of theirs.
struct Asking {
  Asking() {
    for (const char* login : {"ada", "bob", "eve"}) {
      attempt[login] = course.scored_by(login, 50000);
      request[login] = course.trainee(login).ask_for_help(
          {attempt[login], {2000}, std::string("A question of ") + login});
    }
  }
  database::HelpRequest stored(const std::string& login) {
    return course.trainee(login).help_requests().front();
  }

  database::SomeCourse course;
  std::map<std::string, database::AttemptId> attempt;
  std::map<std::string, database::HelpRequestId> request;
};

struct Inbox {
  explicit Inbox(Asking& of, const std::string& login = "kim")
      : visitor(std::make_unique<InboxScreen>(visit_of(of.course, login), navigator, drafts,
                                              [this](int open) { counted.push_back(open); })) {}
  Driver& driver() { return visitor.driver(); }
  void press(std::string_view id) {
    driver().click(id);
    visitor.finish_work();
  }

  SomeNavigator navigator;
  std::shared_ptr<InboxScreen::Drafts> drafts = std::make_shared<InboxScreen::Drafts>();
  std::vector<int> counted;
  SomeVisitor visitor;
};

std::string row_of(const Asking& asking, const std::string& login) {
  return "inbox.row." + std::to_string(asking.request.at(login).number);
}

TEST(InboxScreen, HoldsTheQuestionsOfOnesOwnCohortsOnly) {
  Asking asking;
  Inbox inbox(asking);
  EXPECT_TRUE(inbox.driver().sees("A question of ada"));
  EXPECT_TRUE(inbox.driver().sees("A question of bob"));
  EXPECT_FALSE(shows_word(inbox.driver(), "eve"));
  EXPECT_TRUE(inbox.driver().sees("Open 2"));
  EXPECT_THAT(inbox.counted, ElementsAre(2));
  EXPECT_THAT(inbox.driver().faults(), IsEmpty());
}

TEST(InboxScreen, LeadsToTheMoment) {
  Asking asking;
  Inbox inbox(asking);
  inbox.press(row_of(asking, "bob"));
  inbox.press("inbox.moment");
  EXPECT_THAT(inbox.navigator.asked,
              ElementsAre("replay " + asking.attempt["bob"].text + " at 0.002000"));
}

TEST(InboxScreen, AnAnswerIsSentAndCountsNoLonger) {
  Asking asking;
  Inbox inbox(asking);
  inbox.press(row_of(asking, "ada"));
  expect_reason_by_keyboard(inbox.driver(), "inbox.send");
  inbox.driver().click("inbox.answer");
  inbox.driver().type("The blade was tilted.");
  inbox.press("inbox.send");
  ASSERT_TRUE(asking.stored("ada").answer.has_value());
  EXPECT_EQ(asking.stored("ada").answer->text, "The blade was tilted.");
  EXPECT_TRUE(inbox.driver().sees("Answer sent"));
  EXPECT_THAT(inbox.counted, ElementsAre(2, 1));
  EXPECT_EQ((*inbox.drafts)[asking.request["ada"]], "");
}

TEST(InboxScreen, TheBadgeOfTheNavigationFollowsAnAnswerWithoutATouch) {
  Asking asking;
  SomeNavigator navigator;
  Shell* shell = nullptr;
  SomeVisitor visitor(std::make_unique<InboxScreen>(visit_of(asking.course, "kim"), navigator,
                                                    std::make_shared<InboxScreen::Drafts>(),
                                                    [&](int open) {
                                                      if (shell != nullptr)
                                                        shell->set_badge("nav.inbox", open);
                                                    }));
  shell = &visitor.shell();
  shell->set_visitor(
      Visitor{"Kim", "Instructor", "K", 0, {{"nav.inbox", "Inbox", Icon::Inbox, 2}}});
  visitor.driver().frame();
  visitor.driver().click(row_of(asking, "ada"));
  visitor.finish_work();
  visitor.driver().click("inbox.answer");
  visitor.driver().type("The blade was tilted.");
  visitor.driver().click("inbox.send");
  visitor.finish_work();
  const auto shows_badge = [&](std::string_view count) {
    const Rect row = visitor.driver().widget("nav.inbox").rect;
    for (const SeenText& seen : visitor.driver().content().texts)
      if (seen.text == count && row.contains(seen.rect.centre())) return true;
    return false;
  };
  EXPECT_TRUE(shows_badge("1"));
  EXPECT_TRUE(visitor.driver().sees("Answer sent")) << "the badge takes no message away";
}

TEST(InboxScreen, IsUsedByKeyboardAlone) {
  Asking asking;
  Inbox inbox(asking);
  press_by_keyboard(inbox.visitor, "inbox.filter.1");
  for (int tab = 0; tab < 20 && !inbox.driver().focused().starts_with("inbox.row."); ++tab)
    inbox.driver().press(Key::Tab);
  inbox.driver().press(Key::End);
  inbox.driver().press(Key::Enter);
  press_by_keyboard(inbox.visitor, "inbox.moment");
  EXPECT_EQ(inbox.navigator.asked.size(), 1U);
  inbox.driver().press(Key::Tab);
  EXPECT_EQ(inbox.driver().focused(), "inbox.answer");
  inbox.driver().type("Look again at 00:00.");
  inbox.driver().press(Key::Enter, {.control = true});
  inbox.visitor.finish_work();
  EXPECT_TRUE(asking.stored("bob").answer.has_value());
}

TEST(InboxScreen, ARefusedAnswerStaysWritten) {
  Asking asking;
  Inbox inbox(asking);
  inbox.press(row_of(asking, "ada"));
  inbox.driver().click("inbox.answer");
  inbox.driver().type("Too late");
  asking.course.instructor("kim", asking.course.autumn()).answer(asking.request["ada"], "First");
  inbox.press("inbox.send");
  EXPECT_TRUE(inbox.driver().sees("The answer was not sent"));
  EXPECT_TRUE(inbox.driver().sees("was answered already"));
  EXPECT_EQ((*inbox.drafts)[asking.request["ada"]], "Too late");
  EXPECT_EQ(asking.stored("ada").answer->text, "First");
}

TEST(InboxScreen, WhatWasWrittenIsThereAgainOnTheWayBack) {
  Asking asking;
  Inbox inbox(asking);
  inbox.press(row_of(asking, "ada"));
  inbox.driver().click("inbox.answer");
  inbox.driver().type("Half an ans");
  inbox.visitor.shell().replace_all(std::make_unique<InboxScreen>(
      visit_of(asking.course, "kim"), inbox.navigator, inbox.drafts, InboxScreen::Counted()));
  inbox.driver().frame();
  inbox.visitor.finish_work();
  inbox.press(row_of(asking, "ada"));
  EXPECT_TRUE(inbox.driver().sees("Half an ans"));
}

TEST(InboxScreen, SaysWhereThereAreNoQuestions) {
  database::SomeCourse course;
  SomeNavigator navigator;
  SomeVisitor visitor(std::make_unique<InboxScreen>(visit_of(course, "kim"), navigator,
                                                    std::make_shared<InboxScreen::Drafts>()));
  EXPECT_TRUE(visitor.driver().sees("No help requests"));
  EXPECT_THAT(visitor.driver().faults(), IsEmpty());
}

TEST(InboxScreen, NothingIsCutOffAnywhere) {
  Asking asking;
  asking.course.instructor("kim", asking.course.autumn())
      .answer(asking.request["bob"], std::string(300, 'a') + " and more words behind it");
  SomeNavigator navigator;
  const auto make = [&] {
    return std::make_unique<InboxScreen>(visit_of(asking.course, "kim"), navigator,
                                         std::make_shared<InboxScreen::Drafts>());
  };
  EXPECT_THAT(faults_at_every_size(make), IsEmpty());
  EXPECT_THAT(faults_at_every_size(make,
                                   [&](SomeVisitor& visitor) {
                                     visitor.driver().click("inbox.filter.1");
                                     visitor.driver().click(row_of(asking, "bob"));
                                   }),
              IsEmpty());
}

TEST(QuestionsScreen, ShowsTheOwnQuestionsAndNobodyElses) {
  Asking asking;
  asking.course.instructor("kim", asking.course.autumn())
      .answer(asking.request["ada"], "Hold it level.");
  SomeNavigator navigator;
  SomeVisitor visitor(std::make_unique<QuestionsScreen>(visit_of(asking.course, "ada"), navigator));
  EXPECT_TRUE(visitor.driver().sees("A question of ada"));
  EXPECT_TRUE(visitor.driver().sees("Hold it level."));
  EXPECT_TRUE(visitor.driver().sees("kim"));
  for (const char* other : {"bob", "eve", "lee"})
    EXPECT_FALSE(shows_word(visitor.driver(), other)) << other;
  visitor.driver().click("questions.moment");
  EXPECT_THAT(navigator.asked,
              ElementsAre("replay " + asking.attempt["ada"].text + " at 0.002000"));
}

TEST(QuestionsScreen, IsUsedByKeyboardAlone) {
  Asking asking;
  asking.course.trainee("ada").ask_for_help({asking.attempt["ada"], {3000}, "Another question"});
  SomeNavigator navigator;
  SomeVisitor visitor(std::make_unique<QuestionsScreen>(visit_of(asking.course, "ada"), navigator));
  visitor.driver().press(Key::Tab);
  EXPECT_TRUE(visitor.driver().focused().starts_with("questions.row."));
  visitor.driver().press(Key::End);
  visitor.driver().press(Key::Enter);
  EXPECT_TRUE(visitor.driver().sees("No answer yet"));
  press_by_keyboard(visitor, "questions.moment");
  EXPECT_EQ(navigator.asked.size(), 1U);
}

TEST(QuestionsScreen, SaysWhereThereAreNone) {
  database::SomeCourse course;
  SomeNavigator navigator;
  SomeVisitor visitor(std::make_unique<QuestionsScreen>(visit_of(course, "ada"), navigator));
  EXPECT_TRUE(visitor.driver().sees("No questions yet"));
  EXPECT_THAT(visitor.driver().faults(), IsEmpty());
}

TEST(QuestionsScreen, NothingIsCutOffAnywhere) {
  Asking asking;
  SomeNavigator navigator;
  EXPECT_THAT(faults_at_every_size([&] {
                return std::make_unique<QuestionsScreen>(visit_of(asking.course, "ada"), navigator);
              }),
              IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
