#include "tests/ui/screens/some_reviewer.h"

#include <gtest/gtest.h>

namespace hallux::ui {

SomeReviewer::SomeReviewer(const std::function<std::unique_ptr<Screen>(SomeNavigator&)>& make,
                           float scale, ScenePainter* painter)
    : visitor_(make(navigator_), scale, painter) {
  finish();
}

void SomeReviewer::finish() {
  visitor_.finish_work();
  visitor_.finish_work();
}

void SomeReviewer::tab_to(const std::string& id_begin) {
  for (int presses = 0; presses < 60 && !driver().focused().starts_with(id_begin); ++presses)
    driver().press(Key::Tab);
  ASSERT_TRUE(driver().focused().starts_with(id_begin)) << "Tab does not come to " << id_begin;
}

}  // namespace hallux::ui
