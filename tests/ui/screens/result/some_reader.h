/// Somebody of the course who looks at a result.
#pragma once

#include "tests/ui/screens/some_reviewer.h"
#include "ui/screens/result/result_screen.h"

namespace hallux::ui {

struct Reader : SomeReviewer {
  Reader(database::SomeCourse& course, const std::string& login, const database::AttemptId& attempt,
         float scale = 1.0F)
      : SomeReviewer(
            [&](SomeNavigator& navigator) {
              return std::make_unique<ResultScreen>(visit_of(course, login), navigator, attempt);
            },
            scale) {}
};

}  // namespace hallux::ui
