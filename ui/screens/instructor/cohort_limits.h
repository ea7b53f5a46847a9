/// The dialog of a cohort's screen in which its assessments are limited, and the change that it
/// asks the desk for. Inside this corner only.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "ui/screens/parts/desk_work.h"
#include "ui/screens/parts/limits_dialog.h"

namespace hallux::ui {

class CohortLimits {
 public:
  explicit CohortLimits(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(std::move(signed_in)) {}

  /// Shows what limits there are; `cohort` is one that the person teaches.
  void open(database::CohortId cohort, LimitsForm form);
  /// Draws the dialog while it is open; `changed` is called once a limit was set or cleared.
  void draw(Ui& ui, Shell& shell, std::function<void()> changed);

 private:
  std::shared_ptr<SignedInSession> signed_in_;
  database::CohortId cohort_;
  std::optional<LimitsForm> form_;
  DeskWork work_;
};

}  // namespace hallux::ui
