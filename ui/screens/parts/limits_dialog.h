/// The dialog in which an instructor or an administrator limits the assessments of a cohort.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "database/records/limit.h"
#include "ui/widgets/controls/menu.h"
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
  std::string chosen;
  /// "": as many as they like.
  std::string number;
  TableState table;
};

struct LimitChange {
  std::string scenario_name;
  /// Nothing: no limit any more.
  std::optional<std::int32_t> attempts_max;
};

/// Nothing where no operation is chosen, the number is none, or nothing would change.
std::optional<LimitChange> change_in(const LimitsForm& form);

/// What is said once it was made.
std::string said_of(const Texts& texts, const LimitsForm& form, const LimitChange& change);

/// `fault` says why the last try failed. Controls are named `limits.row.OPERATION`,
/// `limits.number`.
Answer draw_limits_dialog(Ui& ui, LimitsForm& form, const std::string& fault, bool is_busy);

}  // namespace hallux::ui
