#include "ui/screens/person_sheets.h"

#include "ui/screens/page.h"
#include "ui/screens/words.h"
#include "ui/widgets/choice.h"
#include "ui/widgets/field.h"
#include "ui/widgets/sheet.h"

namespace hallux::ui {

namespace {

constexpr float field_gap = 14.0F, code_height = 84.0F;

Rect field_line(Rect& rest, float below) {
  take_top(rest, field_label_height);
  return take_top(rest, field_height, below);
}

void draw_add_fields(Ui& ui, Rect& rest, AddedPersonWords& words) {
  FieldSpec login;
  login.label = ui.text("people.login");
  login.hint = ui.text("people.login.rule");
  login.max_bytes = 64;
  field(ui, "people.add.login", field_line(rest, field_message_height + field_gap), words.login,
        login);
  FieldSpec name;
  name.label = ui.text("people.name.field");
  field(ui, "people.add.name", field_line(rest, field_gap), words.display_name, name);
  checkbox(ui, "people.add.administrator", take_top(rest, 28.0F, field_gap),
           ui.text("people.add.administrator"), words.is_administrator);
  ui.focus_first("people.add.login");
}

}  // namespace

SheetAnswer draw_add_sheet(Ui& ui, AddedPersonWords& words, const std::string& fault,
                           bool is_busy) {
  const float fault_height =
      fault.empty() ? 0.0F : ui.paragraph_height(Type::Small, fault, 432.0F) + field_gap;
  const Sheet sheet(ui, "people.add", {ui.text("people.add.title"), 480.0F, 282.0F + fault_height});
  Rect rest = sheet.content();
  draw_add_fields(ui, rest, words);
  if (!fault.empty()) words_line(ui, rest, Type::Small, ui.theme().bad_text, fault, field_gap);
  Rect line = take_top(rest, button_height);
  ButtonSpec add{ui.text("people.add.act"), ButtonLook::Primary};
  add.is_enabled = !words.login.empty();
  add.is_busy = is_busy;
  const bool is_added =
      button(ui, "people.add.act", take_right(line, button_width(ui, add), 12.0F), add);
  const ButtonSpec cancel{ui.text("people.add.cancel"), ButtonLook::Secondary};
  const bool is_closed =
      button(ui, "people.add.cancel", take_right(line, button_width(ui, cancel)), cancel);
  if (is_added) return SheetAnswer::Done;
  return is_closed || sheet.wants_close() ? SheetAnswer::Closed : SheetAnswer::Waiting;
}

CodeAnswer draw_code_sheet(Ui& ui, const ShownCode& code) {
  const std::string title = ui.texts().say("people.code.title", {{"login", code.whose}});
  const std::string words =
      ui.texts().say("people.code.sentence", {{"moment", moment_text(code.issued.expires_utc)}});
  const float words_height = ui.paragraph_height(Type::Body, words, 432.0F);
  const Sheet sheet(ui, "people.code",
                    {title, 480.0F, words_height + code_height + 40.0F + button_height});
  Rect rest = sheet.content();
  words_line(ui, rest, Type::Body, ui.theme().text_secondary, words, 20.0F);
  const Rect box = take_top(rest, code_height, 20.0F);
  ui.canvas().fill(box, ui.theme().raise, radius::control);
  ui.canvas().set_noting(false);
  ui.canvas().text(box.centre(), {Type::Number, ui.theme().text, Align::Centre},
                   code.issued.code.view());
  ui.canvas().set_noting(true);
  Rect line = take_top(rest, button_height);
  const ButtonSpec done{ui.text("people.code.done"), ButtonLook::Primary};
  const bool is_done =
      button(ui, "people.code.done", take_right(line, button_width(ui, done), 12.0F), done);
  const ButtonSpec copy{ui.text("people.code.copy"), ButtonLook::Secondary, Icon::Copy};
  const bool is_copied =
      button(ui, "people.code.copy", take_right(line, button_width(ui, copy)), copy);
  ui.focus_first("people.code.copy");
  if (is_copied) ui.clipboard().write(code.issued.code.view());
  if (is_done || sheet.wants_close()) return CodeAnswer::Done;
  return is_copied ? CodeAnswer::Copied : CodeAnswer::Waiting;
}

}  // namespace hallux::ui
