#include "tests/ui/screens/some_visitor.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>

namespace hallux::ui {

namespace {

DriverSetting at_scale(float scale) {
  DriverSetting setting;
  setting.width *= scale;
  setting.height *= scale;
  setting.scale = scale;
  return setting;
}

}  // namespace

std::shared_ptr<SignedInSession> visit_of(database::SomeCourse& course, const std::string& login,
                                          const database::OpenOptions& options) {
  return std::make_shared<SignedInSession>(
      database::Database::open(course.database().directory(), options),
      [&](database::Database& database) {
        return database::sign_in(database, login, database::secret(database::good_password),
                                 database::cheap);
      });
}

void expect_reason_by_keyboard(Driver& driver, const std::string& id) {
  for (int presses = 0; presses < 60 && driver.focused() != id; ++presses) driver.press(Key::Tab);
  ASSERT_EQ(driver.focused(), id) << "Tab does not come to it";
  const Widget off = driver.widget(id);
  EXPECT_FALSE(off.is_enabled) << id;
  EXPECT_TRUE(driver.sees(off.why_off)) << off.why_off;
  driver.press(Key::Space);
  driver.press(Key::Enter);
  EXPECT_TRUE(driver.has(id));
  EXPECT_EQ(driver.focused(), id);
}

SomeVisitor::SomeVisitor(std::unique_ptr<Screen> screen, float scale, ScenePainter* painter)
    : driver_(
          texts_,
          [this, painter](Ui& ui) {
            if (painter == nullptr) return shell_.draw(ui);
            shell_.draw(ui, *painter);
          },
          at_scale(scale)) {
  shell_.set_display_scale(scale);
  shell_.preferences().is_motion_reduced = true;
  shell_.push(std::move(screen));
  driver_.frame();
  driver_.settle();
  finish_work();
}

void SomeVisitor::finish_work() {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!shell_.background().is_idle()) {
    if (std::chrono::steady_clock::now() > end) {
      ADD_FAILURE() << "work did not end within a minute";
      return;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    driver_.frame();
  }
  driver_.frame();
  driver_.settle();
}

}  // namespace hallux::ui
