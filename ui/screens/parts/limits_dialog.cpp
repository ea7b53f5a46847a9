#include "ui/screens/parts/limits_dialog.h"

#include <algorithm>
#include <charconv>

#include "ui/screens/parts/course_text.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {

namespace {

constexpr float list_height = 236.0F, gap = 14.0F, row_height = 38.0F;
constexpr std::int32_t number_most = 1000;

std::optional<std::int32_t> limit_of(const LimitsForm& form, const std::string& operation) {
  for (const database::AttemptLimit& limit : form.limits)
    if (limit.scenario_name == operation) return limit.attempts_max;
  return std::nullopt;
}

std::optional<std::int32_t> number_in(const std::string& text) {
  std::int32_t number = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, number);
  const bool is_number = read.ec == std::errc() && read.ptr == end;
  if (!is_number || number < 1 || number > number_most) return std::nullopt;
  return number;
}

void choose(LimitsForm& form, const std::string& operation) {
  form.chosen = operation;
  const auto limit = limit_of(form, operation);
  form.number = limit ? std::to_string(*limit) : std::string();
}

void draw_operations(Ui& ui, const Rect& rect, LimitsForm& form) {
  const auto number = [&](Ui& own, const std::string& operation, const Rect& cell) {
    const auto limit = limit_of(form, operation);
    const Color color = limit ? own.theme().text : own.theme().text_caption;
    own.canvas().text_in(cell, {Type::Body, color, Align::Right},
                         limit ? std::to_string(*limit) : std::string(own.text("limits.none")),
                         true);
  };
  RowTable<std::string> shown{ui.text("limits.operations"),
                              [](const std::string& operation) { return operation; },
                              operation_text,
                              {{{ui.text("limits.operation")}, operation_text, name_cell},
                               {{ui.text("limits.number"), 150.0F, 1.0F, Align::Right}, number}}};
  shown.row_height = row_height;
  form.table.chosen.clear();
  if (!form.chosen.empty()) form.table.chosen.insert(form.chosen);
  const TableResponse response = table(ui, "limits.row", rect, shown, form.operations, form.table);
  if (!response.opened) return;
  choose(form, form.operations[static_cast<std::size_t>(*response.opened)]);
  ui.want_frame_in_s(0.0);
}

void draw_form(Ui& ui, Rect rest, LimitsForm& form) {
  draw_operations(ui, take_top(rest, list_height, gap), form);
  take_top(rest, field_label_height);
  FieldSpec number;
  number.label = ui.text("limits.number");
  number.hint = ui.text("limits.number.hint");
  number.max_bytes = 4;
  if (form.chosen.empty()) number.why_off = ui.text("limits.missing.operation");
  if (!form.number.empty() && !number_in(form.number)) number.error = ui.text("limits.number.rule");
  const Rect line = take_top(rest, field_height);
  if (field(ui, "limits.number", {line.x, line.y, std::min(line.w, 240.0F), line.h}, form.number,
            number))
    ui.want_frame_in_s(0.0);
}

/// Nothing where no operation is chosen, the number is none, or nothing would change.
std::optional<LimitChange> change_in(const LimitsForm& form) {
  if (form.chosen.empty()) return std::nullopt;
  const auto before = limit_of(form, form.chosen), wanted = number_in(form.number);
  if ((!form.number.empty() && !wanted) || before == wanted) return std::nullopt;
  return LimitChange{form.chosen, wanted};
}

/// Why nothing would change.
std::string_view missing_in(const Ui& ui, const LimitsForm& form) {
  if (form.chosen.empty()) return ui.text("limits.missing.operation");
  if (!form.number.empty() && !number_in(form.number)) return ui.text("limits.number.rule");
  return change_in(form) ? std::string_view() : ui.text("limits.missing.change");
}

/// What is said once it was made.
std::string said_of(const Texts& texts, const LimitsForm& form, const LimitChange& change) {
  const TextValues about{{"operation", operation_text(change.scenario_name)},
                         {"cohort", form.cohort_name}};
  return change.attempts_max ? texts.say_count("limits.set", *change.attempts_max, about)
                             : texts.say("limits.cleared", about);
}

}  // namespace

void LimitsDialog::open(LimitsForm form) {
  form_ = std::move(form);
  work_.forget_fault();
}

void LimitsDialog::draw(Ui& ui, Shell& shell, const Apply& apply, std::function<void()> changed) {
  if (!form_) return;
  const std::string title = ui.texts().say("limits.title", {{"cohort", form_->cohort_name}});
  Dialog shown =
      form_dialog(ui, title, ui.text("limits.act"), {work_.fault(), work_.is_running()},
                  list_height + gap + field_label_height + field_height + field_message_height);
  shown.sentence = ui.text("limits.sentence");
  const Answer answer = dialog(ui, "limits", shown, [&](const Rect& rect) {
    draw_form(ui, rect, *form_);
    return missing_in(ui, *form_);
  });
  if (answer == Answer::Keep) form_.reset();
  const std::optional<LimitChange> change =
      answer == Answer::Act ? change_in(*form_) : std::nullopt;
  if (!change) return;
  work_.change(
      shell, signed_in_, {std::string(ui.text("limits.changing")), {}},
      [apply, change = *change](database::Session& session) { apply(session, change); },
      [this, &shell, changed = std::move(changed), done = said_of(ui.texts(), *form_, *change)] {
        form_.reset();
        shell.say({Meaning::Good, done});
        changed();
      });
}

}  // namespace hallux::ui
