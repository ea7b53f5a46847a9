// Somebody who presses and types anything, as an administrator and as an instructor: no crash, no
// dead end, nothing cut off, and never a stranger's name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/ui/screens/every_size.h"
#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_visitor.h"
#include "ui/screens/administrator/audit_screen.h"
#include "ui/screens/administrator/cohorts_screen.h"
#include "ui/screens/administrator/people_screen.h"
#include "ui/screens/administrator/scenarios_screen.h"
#include "ui/screens/instructor/cohort_screen.h"
#include "ui/screens/instructor/inbox_screen.h"
#include "ui/screens/trainee/questions_screen.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

constexpr int steps = 500;

/// Walks through the screens of one person; the seed is said where something is wrong.
class Walker {
 public:
  using MakeScreen = std::function<std::unique_ptr<Screen>(const std::string& place)>;

  Walker(std::vector<std::string> places, const MakeScreen& make)
      : visitor_(make(places.front())), random_(20261122) {
    Visitor who;
    who.name = "Walker";
    for (const std::string& place : places) who.places.push_back({place, place, Icon::Home, 0});
    visitor_.shell().set_visitor(who);
    visitor_.shell().on_navigate(
        [this, make](const std::string& place) { visitor_.shell().replace_all(make(place)); });
    visitor_.driver().frame();
    visitor_.finish_work();
  }

  void step() {
    const unsigned chance = static_cast<unsigned>(random_() % 10U);
    if (chance < 6U) {
      press_anything();
    } else if (chance < 8U) {
      constexpr std::array<Key, 9> keys{Key::Tab,   Key::Enter, Key::Escape, Key::Space, Key::Down,
                                        Key::Right, Key::End,   Key::Up,     Key::Home};
      visitor_.driver().press(keys[random_() % keys.size()]);
    } else {
      visitor_.driver().type(chance == 8U ? "trainee-" + std::to_string(random_() % 100U) : "a b");
    }
    visitor_.finish_work();
  }
  Driver& driver() { return visitor_.driver(); }

 private:
  void press_anything() {
    std::vector<std::string> ids;
    const FrameContent& content = driver().content();
    for (const Widget& widget : content.widgets) {
      const bool is_in_sight = widget.visible.h >= 8.0F && widget.visible.w >= 8.0F;
      if (!is_in_sight || !widget.is_enabled || widget.role == Role::Area ||
          widget.role == Role::Scroll || widget.layer < reachable_layer(content))
        continue;
      const Widget* under = widget_at(content, widget.visible.centre());
      if (under != nullptr && under->id == widget.id) ids.push_back(widget.id);
    }
    ASSERT_THAT(ids, testing::Not(IsEmpty())) << "a dead end";
    driver().click(ids[random_() % ids.size()]);
  }

  SomeVisitor visitor_;
  std::mt19937 random_;
};

TEST(StaffWalk, AnAdministratorWhoPressesAnythingComesToNoHarm) {
  database::SomeCourse course;
  const std::shared_ptr<SignedInSession> signed_in = visit_of(course, "root");
  Walker walker({"nav.people", "nav.cohorts", "nav.scenarios", "nav.records"},
                [&](const std::string& place) -> std::unique_ptr<Screen> {
                  if (place == "nav.people")
                    return std::make_unique<PeopleScreen>(signed_in, database::cheap);
                  if (place == "nav.cohorts") return std::make_unique<CohortsScreen>(signed_in);
                  if (place == "nav.scenarios") return std::make_unique<ScenariosScreen>(signed_in);
                  return std::make_unique<AuditScreen>(signed_in);
                });
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    walker.step();
    EXPECT_THAT(walker.driver().faults(), IsEmpty()) << "step " << step;
  }
}

TEST(StaffWalk, AnInstructorSeesNoStranger) {
  database::SomeCourse course;
  course.scored_by("bob", 70000);
  const auto attempt = course.scored_by("ada", 61000), of_eve = course.scored_by("eve", 33000);
  course.trainee("ada").ask_for_help({attempt, {2000}, "Why?"});
  course.trainee("eve").ask_for_help({of_eve, {2000}, "A question of another cohort"});
  SomeNavigator navigator;
  const std::shared_ptr<SignedInSession> signed_in = visit_of(course, "kim");
  const auto drafts = std::make_shared<InboxScreen::Drafts>();
  Walker walker({"nav.cohort", "nav.inbox", "nav.questions"},
                [&](const std::string& place) -> std::unique_ptr<Screen> {
                  if (place == "nav.cohort")
                    return std::make_unique<CohortScreen>(signed_in, navigator, [] {});
                  if (place == "nav.inbox")
                    return std::make_unique<InboxScreen>(signed_in, navigator, drafts);
                  return std::make_unique<QuestionsScreen>(signed_in, navigator);
                });
  for (int step = 0; step < steps && !testing::Test::HasFailure(); ++step) {
    walker.step();
    EXPECT_THAT(walker.driver().faults(), IsEmpty()) << "step " << step;
    EXPECT_FALSE(shows_word(walker.driver(), "eve")) << "step " << step;
    EXPECT_FALSE(walker.driver().sees("another cohort")) << "step " << step;
  }
}

}  // namespace
}  // namespace hallux::ui
