#include "ui/screens/parts/person_dialogs.h"

#include "ui/screens/parts/value_text.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {

namespace {

constexpr float field_gap = 14.0F, code_height = 84.0F, checkbox_height = 28.0F;
constexpr float add_height =
    2.0F * (field_label_height + field_height + field_gap) + field_message_height + checkbox_height;

constexpr float password_height =
    3.0F * (field_label_height + field_height + field_gap) + 2.0F * field_message_height;

Rect field_line(Rect& rest, float below) {
  take_top(rest, field_label_height);
  return take_top(rest, field_height, below);
}

void draw_add_fields(Ui& ui, Rect rest, AddedPersonWords& words) {
  FieldSpec login;
  login.label = ui.text("people.login");
  login.hint = ui.text("people.login.rule");
  login.max_bytes = 64;
  field(ui, "people.add.login", field_line(rest, field_message_height + field_gap), words.login,
        login);
  FieldSpec name;
  name.label = ui.text("people.name.field");
  field(ui, "people.add.name", field_line(rest, field_gap), words.display_name, name);
  checkbox(ui, "people.add.administrator", take_top(rest, checkbox_height),
           ui.text("people.add.administrator"), words.is_administrator);
  ui.focus_first("people.add.login");
}

/// True where all three are there and the new one was written the same twice.
bool draw_password_fields(Ui& ui, Rect rest, PasswordWords& words) {
  FieldSpec secret;
  secret.is_secret = true;
  secret.label = ui.text("account.password.old");
  field(ui, "account.password.old", field_line(rest, field_gap), words.old_password, secret);
  secret.label = ui.text("entry.new_password");
  secret.hint = ui.text("entry.password.rule");
  field(ui, "account.password.new", field_line(rest, field_message_height + field_gap),
        words.new_password, secret);
  secret.label = ui.text("entry.password_again");
  secret.hint = {};
  const auto is_same = [&] { return words.new_password == words.new_password_again; };
  if (!is_same() && words.new_password_again.size() >= words.new_password.size())
    secret.error = ui.text("entry.passwords_differ");
  const bool is_changed =
      field(ui, "account.password.again", field_line(rest, field_message_height + field_gap),
            words.new_password_again, secret);
  if (is_changed) ui.want_frame_in_s(0.0);  // what was said below it was about the frame before
  ui.focus_first("account.password.old");
  return is_same() && !words.old_password.empty() && !words.new_password.empty();
}

/// The code, large, and a button beside it. True where it was copied.
bool draw_code(Ui& ui, Rect line, const ShownCode& code) {
  const ButtonSpec copy{ui.text("people.code.copy"), ButtonLook::Secondary, Icon::Copy};
  const Rect place = take_right(line, button_width(ui, copy), 12.0F);
  ui.canvas().fill(line, ui.theme().raise, radius::control);
  ui.canvas().set_noting(false);
  ui.canvas().text(line.centre(), {Type::Number, ui.theme().text, Align::Centre},
                   code.issued.code.view());
  ui.canvas().set_noting(true);
  const bool is_copied =
      button(ui, "people.code.copy", centred(place, place.w, button_height), copy);
  ui.focus_first("people.code.copy");
  if (is_copied) ui.clipboard().write(code.issued.code.view());
  return is_copied;
}

}  // namespace

Answer draw_add_dialog(Ui& ui, AddedPersonWords& words, const std::string& fault, bool is_busy) {
  const Dialog shown = form_dialog(ui, ui.text("people.add.title"), ui.text("people.add.act"),
                                   {fault, is_busy}, add_height);
  return dialog(ui, "people.add", shown, [&](const Rect& form) {
    draw_add_fields(ui, form, words);
    return !words.login.empty();
  });
}

PasswordWords::~PasswordWords() {
  for (std::string* secret : {&old_password, &new_password, &new_password_again}) {
    database::SecretText::take(*secret);  // wipes what it takes
  }
}

Answer draw_password_dialog(Ui& ui, PasswordWords& words, const std::string& fault, bool is_busy) {
  const Dialog shown =
      form_dialog(ui, ui.text("account.password.title"), ui.text("account.password.act"),
                  {fault, is_busy}, password_height);
  return dialog(ui, "account.password", shown,
                [&](const Rect& form) { return draw_password_fields(ui, form, words); });
}

CodeAnswer draw_code_dialog(Ui& ui, const ShownCode& code) {
  const std::string title = ui.texts().say("people.code.title", {{"login", code.whose}});
  const std::string words =
      ui.texts().say("people.code.sentence", {{"moment", moment_text(code.issued.expires_utc)}});
  Dialog shown;
  shown.title = title;
  shown.sentence = words;
  shown.act = ui.text("people.code.done");
  shown.act_name = "done";
  shown.form_height = code_height;
  bool is_copied = false;
  const Answer answer = dialog(ui, "people.code", shown, [&](const Rect& form) {
    is_copied = draw_code(ui, form, code);
    return true;
  });
  if (answer != Answer::Waiting) return CodeAnswer::Done;
  return is_copied ? CodeAnswer::Copied : CodeAnswer::Waiting;
}

}  // namespace hallux::ui
