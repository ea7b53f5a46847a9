/// An attempt that ada operated, and somebody of the course who looks at it: for the tests of
/// result and replay.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tests/ui/screens/some_navigator.h"
#include "tests/ui/screens/some_operation.h"
#include "tests/ui/screens/some_visitor.h"

namespace hallux::ui {

/// Ada's Akin, recorded and scored.
struct OperatedCourse {
  database::SomeCourse course;
  SomeOperation operation = some_operation();
  database::AttemptId attempt = operated_by(course, "ada", operation);
};

class SomeReviewer {
 public:
  /// `make` makes the screen, which leads on by that navigator.
  explicit SomeReviewer(const std::function<std::unique_ptr<Screen>(SomeNavigator&)>& make,
                        float scale = 1.0F, ScenePainter* painter = nullptr);

  /// What is done starts what is read anew.
  void finish();
  /// Tab until the first control whose id begins so has the focus.
  /// errors  fails the test where Tab does not come there
  void tab_to(const std::string& id_begin);
  Driver& driver() noexcept { return visitor_.driver(); }
  /// Where the screen wanted to lead.
  const std::vector<std::string>& asked() const noexcept { return navigator_.asked; }

 private:
  SomeNavigator navigator_;
  SomeVisitor visitor_;
};

}  // namespace hallux::ui
