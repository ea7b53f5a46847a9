/// The dialog in which an instructor or an administrator limits the assessments of a cohort.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "database/records/limit.h"
#include "ui/screens/parts/desk_work.h"
#include "ui/widgets/controls/row_table.h"

namespace hallux::ui {

/// What is chosen and typed; it stays while a refusal is read.
struct LimitsForm {
  std::string cohort_name;
  /// By name.
  std::vector<std::string> operations;
  /// Those that there are.
  std::vector<database::AttemptLimit> limits;
  /// Operation; "": none yet.
  std::string chosen = {};
  /// "": as many as they like.
  std::string number = {};
  TableState table = {};
};

struct LimitChange {
  std::string scenario_name;
  /// Nothing: no limit any more.
  std::optional<std::int32_t> attempts_max;
};

class LimitsDialog {
 public:
  /// Sets or clears a limit from the desk that the person has; it holds nothing of the screen's.
  using Apply = std::function<void(database::Session&, const LimitChange&)>;

  explicit LimitsDialog(std::shared_ptr<SignedInSession> signed_in)
      : signed_in_(std::move(signed_in)) {}

  void open(LimitsForm form);
  /// Draws the dialog while it is open; `changed` is called once a limit was set or cleared.
  /// Controls are named `limits.row.OPERATION`, `limits.number`.
  void draw(Ui& ui, Shell& shell, const Apply& apply, std::function<void()> changed);

 private:
  std::shared_ptr<SignedInSession> signed_in_;
  std::optional<LimitsForm> form_;
  DeskWork work_;
};

}  // namespace hallux::ui
