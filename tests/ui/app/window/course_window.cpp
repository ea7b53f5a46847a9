#include "tests/ui/app/window/course_window.h"

#include <chrono>
#include <thread>

namespace hallux::ui {

CourseWindow::CourseWindow(const std::filesystem::path& data_directory, database::PasswordCost cost,
                           const DrawFrame& draw_frame, const DriverSetting& setting)
    : course_(texts_, data_directory, shell_, cost),
      driver_(
          texts_, [this, draw_frame](Ui& ui) { draw_frame(shell_, ui); }, setting) {
  shell_.preferences().is_motion_reduced = true;
  shell_.preferences().is_saw_heard = false;
  shell_.set_display_scale(setting.scale);
  finish_work();
}

bool CourseWindow::finish_work(double timeout_s) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout_s);
  while (!shell_.background().is_idle()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    driver_.frame();
  }
  driver_.frame();
  driver_.settle();
  return true;
}

void CourseWindow::sign_in(const std::string& login, const std::string& password) {
  driver_.click("entry.login");
  driver_.press(Key::A, {.control = true});
  driver_.type(login);
  driver_.click("entry.password");
  driver_.press(Key::A, {.control = true});
  driver_.type(password);
  driver_.press(Key::Enter);
  finish_work();
}

}  // namespace hallux::ui
