/// The whole course driven without a window: every screen behind its places, as the command opens
/// it.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "tests/ui/widgets/driver.h"
#include "ui/app/window/course.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class CourseWindow {
 public:
  using DrawFrame = std::function<void(Shell& shell, Ui& ui)>;

  /// `cost` is that of passwords; `draw_frame` draws the shell, with whatever graphics there are.
  CourseWindow(const std::filesystem::path& data_directory, database::PasswordCost cost,
               const DrawFrame& draw_frame, const DriverSetting& setting = {});

  Driver& driver() noexcept { return driver_; }
  Shell& shell() noexcept { return shell_; }

  /// Makes frames until no work runs beside the window, at most `timeout_s` of real time. False
  /// where some still runs.
  bool finish_work(double timeout_s = 60.0);
  /// From the form: signs in, and waits for the first place.
  void sign_in(const std::string& login, const std::string& password);

 private:
  Shell shell_;
  const Texts texts_ = english_texts();
  Course course_;
  Driver driver_;
};

}  // namespace hallux::ui
