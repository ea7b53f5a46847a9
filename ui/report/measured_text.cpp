#include "ui/report/measured_text.h"

#include "assessment/number_text.h"
#include "scenarios/metric_names.h"

namespace hallux::ui {

using database::LedgerKind;

std::string with_true_minus(std::string number) {
  if (number.starts_with('-')) number.replace(0, 1, "\xE2\x88\x92");
  return number;
}

std::string measured_text(double value, std::string_view unit) {
  return with_true_minus(assessment::value_text(value, unit));
}

std::string measured_text(const database::LedgerLine& line) {
  if (!line.is_measured) return "\xE2\x80\x93";
  if (line.kind == LedgerKind::Damping)
    return assessment::number_text(100.0 * line.value, 0) + " %";
  if (!scenarios::is_claim(line.metric)) return measured_text(line.value, line.unit);
  // Only a gate that was met has a line.
  return line.kind == LedgerKind::Gate || line.value > 0.5 ? "yes" : "no";
}

}  // namespace hallux::ui
