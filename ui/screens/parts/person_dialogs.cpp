#include "ui/screens/parts/person_dialogs.h"

#include "ui/screens/parts/value_text.h"
#include "ui/times/local_time.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {

namespace {

constexpr float field_gap = 14.0F, code_height = 84.0F, checkbox_height = 28.0F;
constexpr float add_height =
    2.0F * (field_label_height + field_height + field_gap) + field_message_height + checkbox_height;

constexpr float password_height =
    3.0F * (field_label_height + field_height + field_gap) + 2.0F * field_message_height;

constexpr float erase_height =
    3.0F * (field_label_height + field_height + field_gap) + field_message_height + checkbox_height;

void draw_add_fields(Ui& ui, Rect rest, NewPersonForm& form) {
  FieldSpec login{
      .label = ui.text("people.login"), .hint = ui.text("people.login.rule"), .max_bytes = 64};
  if (!database::may_become_login(form.login)) login.error = ui.text("people.login.fault");
  if (labelled_field(ui, "people.add.login", rest, form.login, login,
                     field_message_height + field_gap))
    ui.want_frame_in_s(0.0);  // what was said below it was about the frame before
  labelled_field(ui, "people.add.name", rest, form.display_name,
                 {.label = ui.text("people.name.field")}, field_gap);
  checkbox(ui, "people.add.administrator", take_top(rest, checkbox_height),
           ui.text("people.add.administrator"), form.is_administrator);
  ui.focus_first("people.add.login");
}

/// What is missing: all three, and the new one written the same twice.
std::string_view draw_password_fields(Ui& ui, Rect rest, PasswordForm& form) {
  FieldSpec secret{.label = ui.text("account.password.old"), .is_secret = true};
  labelled_field(ui, "account.password.old", rest, form.old_password, secret, field_gap);
  secret.label = ui.text("entry.new_password");
  secret.hint = ui.text("entry.password.rule");
  labelled_field(ui, "account.password.new", rest, form.new_password, secret,
                 field_message_height + field_gap);
  secret.label = ui.text("entry.password_again");
  secret.hint = {};
  const auto is_same = [&] { return form.new_password == form.new_password_again; };
  if (!is_same() && form.new_password_again.size() >= form.new_password.size())
    secret.error = ui.text("entry.passwords_differ");
  const bool is_changed =
      labelled_field(ui, "account.password.again", rest, form.new_password_again, secret,
                     field_message_height + field_gap);
  if (is_changed) ui.want_frame_in_s(0.0);  // what was said below it was about the frame before
  ui.focus_first("account.password.old");
  if (form.old_password.empty()) return ui.text("account.password.missing.old");
  if (form.new_password.empty()) return ui.text("account.password.missing.new");
  return is_same() ? std::string_view() : ui.text("entry.passwords_differ");
}

/// What is missing: all three, and the login must be theirs.
std::string_view draw_erase_fields(Ui& ui, Rect rest, EraseForm& form) {
  const std::string label = ui.texts().say("people.erase.login", {{"login", form.login}});
  labelled_field(ui, "people.erase.login", rest, form.typed_login,
                 {.label = label, .max_bytes = 64}, field_gap);
  labelled_field(
      ui, "people.erase.reason", rest, form.reason,
      {.label = ui.text("people.erase.reason"), .hint = ui.text("people.erase.reason.rule")},
      field_message_height + field_gap);
  labelled_field(ui, "people.erase.password", rest, form.password,
                 {.label = ui.text("people.erase.password"), .is_secret = true}, field_gap);
  checkbox(ui, "people.erase.recordings", take_top(rest, checkbox_height),
           ui.text("people.erase.recordings"), form.with_recordings);
  ui.focus_first("people.erase.login");
  if (form.typed_login != form.login) return ui.text("people.erase.missing.login");
  if (form.reason.empty()) return ui.text("people.erase.missing.reason");
  return form.password.empty() ? ui.text("people.erase.missing.password") : std::string_view();
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

Answer draw_add_dialog(Ui& ui, NewPersonForm& form, const std::string& fault, bool is_busy) {
  const Dialog shown = form_dialog(ui, ui.text("people.add.title"), ui.text("people.add.act"),
                                   {fault, is_busy}, add_height);
  return dialog(ui, "people.add", shown, [&](const Rect& rect) {
    draw_add_fields(ui, rect, form);
    if (form.login.empty()) return ui.text("people.missing.login");
    return database::is_login(form.login) ? std::string_view() : ui.text("people.login.fault");
  });
}

Answer draw_name_dialog(Ui& ui, NameForm& form, const std::string& fault, bool is_busy) {
  const std::string title = ui.texts().say("people.rename.title", {{"login", form.login}});
  Dialog shown = form_dialog(ui, title, ui.text("people.rename.act"), {fault, is_busy},
                             field_label_height + field_height);
  shown.sentence = ui.text("people.rename.sentence");
  return dialog(ui, "people.rename", shown, [&](const Rect& rect) {
    Rect rest = rect;
    labelled_field(ui, "people.rename.name", rest, form.name,
                   {.label = ui.text("people.name.field")});
    ui.focus_first("people.rename.name");
    if (form.name.find_first_not_of(' ') == std::string::npos)
      return ui.text("people.missing.name");
    return form.name != form.before ? std::string_view() : ui.text("people.rename.unchanged");
  });
}

PasswordForm::~PasswordForm() {
  for (std::string* secret : {&old_password, &new_password, &new_password_again}) wipe(*secret);
}

Answer draw_password_dialog(Ui& ui, PasswordForm& form, const std::string& fault, bool is_busy) {
  const Dialog shown =
      form_dialog(ui, ui.text("account.password.title"), ui.text("account.password.act"),
                  {fault, is_busy}, password_height);
  return dialog(ui, "account.password", shown,
                [&](const Rect& rect) { return draw_password_fields(ui, rect, form); });
}

EraseForm::~EraseForm() { wipe(password); }

Answer draw_erase_dialog(Ui& ui, EraseForm& form, const std::string& fault, bool is_busy) {
  const std::string title = ui.texts().say("people.erase.title", {{"login", form.login}});
  Dialog shown =
      form_dialog(ui, title, ui.text("people.erase.act"), {fault, is_busy}, erase_height);
  shown.keep = ui.text("people.keep");
  shown.sentence = ui.text("people.erase.sentence");
  shown.is_dangerous = true;
  return dialog(ui, "people.erase", shown,
                [&](const Rect& rect) { return draw_erase_fields(ui, rect, form); });
}

CodeAnswer draw_code_dialog(Ui& ui, const ShownCode& code) {
  const std::string title = ui.texts().say("people.code.title", {{"login", code.whose}});
  const std::string words = ui.texts().say("people.code.sentence",
                                           {{"moment", full_moment_text(code.issued.expires_utc)}});
  Dialog shown;
  shown.title = title;
  shown.sentence = words;
  shown.act = ui.text("people.code.done");
  shown.act_name = "done";
  shown.form_height = code_height;
  bool is_copied = false;
  const Answer answer = dialog(ui, "people.code", shown, [&](const Rect& form) {
    is_copied = draw_code(ui, form, code);
    return std::string_view();
  });
  if (answer != Answer::Waiting) return CodeAnswer::Done;
  return is_copied ? CodeAnswer::Copied : CodeAnswer::Waiting;
}

}  // namespace hallux::ui
