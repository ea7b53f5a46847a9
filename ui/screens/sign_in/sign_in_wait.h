/// After wrong passwords the next try has to wait: how long still, counted down where it is said.
/// Inside this corner only.
#pragma once

#include <string>
#include <utility>

#include "database/people/sign_in_guard.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// Between the fields of the forms to come in.
inline constexpr float entry_field_gap = 14.0F;

class SignInWait {
 public:
  /// Runs a try; where it came too soon, remembers for how long, and lets the refusal through.
  /// thread  that of the work; the others belong to the window, after the work ended
  template <typename Try>
  void noting(Try&& attempt) {
    try {
      std::forward<Try>(attempt)();
    } catch (const database::TooSoon& soon) {
      told_s_ = soon.wait_s();
      throw;
    }
  }
  /// Whole seconds left in this frame; 0: one may try.
  int left_s(Ui& ui);
  /// Draws why the last try failed and cuts it off `column`. The wait stands in place of what was
  /// said, second by second, and is gone when it is over.
  void draw_fault(Ui& ui, Rect& column, std::string& fault);

 private:
  int told_s_ = 0;
  /// Frame time; below 0: no wait.
  double until_s_ = -1.0;
};

}  // namespace hallux::ui
