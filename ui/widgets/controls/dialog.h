/// A form over everything: a few fields, the verb and the way out.
///
///     const Dialog shown = form_dialog(ui, ui.text("cohorts.add"), ui.text("cohorts.add"),
///                                      {fault, is_busy}, field_label_height + field_height);
///     const Answer answer = dialog(ui, "cohorts.new", shown, [&](const Rect& form) {
///       field(ui, "cohorts.new.name", inset(form, ...), name_, spec);
///       return name_.empty() ? ui.text("people.missing.name") : std::string_view();
///     });
#pragma once

#include <functional>
#include <string_view>

#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

inline constexpr float dialog_width = 520.0F;

struct Dialog {
  std::string_view title = {}, sentence = {};
  /// The verb: "Pin note".
  std::string_view act = {};
  /// The way out: "Cancel"; empty: only the verb, and Esc.
  std::string_view keep = {};
  /// What the id of the verb ends with.
  std::string_view act_name = "act";
  /// Why the last try failed; empty: nothing is wrong.
  std::string_view error = {};
  /// Less where the window is narrower.
  float width = dialog_width;
  /// That the fields need.
  float form_height = 0.0F;
  /// The work that it began still runs.
  bool is_busy = false;
  bool is_dangerous = false;
};

/// How it stands with what a form began: why the last try failed, and whether it still runs.
struct FormState {
  std::string_view fault = {};
  bool is_busy = false;
};

/// A form whose way out is "Cancel".
Dialog form_dialog(const Ui& ui, std::string_view title, std::string_view act,
                   const FormState& state, float form_height);

/// Draws it with the fields that `draw_form` draws into the place it is given; it answers what is
/// still missing, in words of the catalogue: while it is anything, the verb is off for that reason.
/// Buttons are named
/// `id.act`, which Enter presses (Ctrl+Enter in a field of several lines), and `id.keep`, which Esc
/// presses. Where the window is too low all between title and buttons scrolls, named `id.form`.
Answer dialog(Ui& ui, std::string_view id, const Dialog& shown,
              const std::function<std::string_view(const Rect& form)>& draw_form);

}  // namespace hallux::ui
