/// Screens driven without a window: a shell, its driver, and waiting for the work that runs beside
/// it.
#pragma once

#include "tests/database/some_course.h"
#include "tests/ui/widgets/driver.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

/// Somebody of the course, signed in.
std::shared_ptr<SignedInSession> visit_of(database::SomeCourse& course, const std::string& login,
                                          const database::OpenOptions& options = {});

/// Tab comes to the control that is off, and shows why it is; neither Space nor Enter presses it.
void expect_reason_by_keyboard(Driver& driver, const std::string& id);

class SomeVisitor {
 public:
  /// A painter that is given is asked for the pictures.
  explicit SomeVisitor(std::unique_ptr<Screen> screen, float scale = 1.0F,
                       ScenePainter* painter = nullptr);

  Shell& shell() noexcept { return shell_; }
  Driver& driver() noexcept { return driver_; }
  /// Makes frames until no work runs beside the window.
  /// errors  fails the test after a minute
  void finish_work();

 private:
  Shell shell_;
  const Texts texts_ = english_texts();
  Driver driver_;
};

}  // namespace hallux::ui
