#include "ui/screens/administrator/erase_dialog.h"

#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {

namespace {

constexpr float field_gap = 14.0F, checkbox_height = 28.0F;
constexpr float form_height =
    3.0F * (field_label_height + field_height + field_gap) + field_message_height + checkbox_height;

Rect field_line(Rect& rest, float below) {
  take_top(rest, field_label_height);
  return take_top(rest, field_height, below);
}

/// True where all is there and the login is theirs.
bool draw_fields(Ui& ui, Rect rest, EraseWords& words) {
  FieldSpec login;
  const std::string label = ui.texts().say("people.erase.login", {{"login", words.login}});
  login.label = label;
  login.max_bytes = 64;
  field(ui, "people.erase.login", field_line(rest, field_gap), words.typed_login, login);
  FieldSpec reason;
  reason.label = ui.text("people.erase.reason");
  reason.hint = ui.text("people.erase.reason.rule");
  field(ui, "people.erase.reason", field_line(rest, field_message_height + field_gap), words.reason,
        reason);
  FieldSpec secret;
  secret.label = ui.text("people.erase.password");
  secret.is_secret = true;
  field(ui, "people.erase.password", field_line(rest, field_gap), words.password, secret);
  checkbox(ui, "people.erase.recordings", take_top(rest, checkbox_height),
           ui.text("people.erase.recordings"), words.with_recordings);
  ui.focus_first("people.erase.login");
  return words.typed_login == words.login && !words.reason.empty() && !words.password.empty();
}

}  // namespace

EraseWords::~EraseWords() { wipe(password); }

Answer draw_erase_dialog(Ui& ui, EraseWords& words, const std::string& fault, bool is_busy) {
  const std::string title = ui.texts().say("people.erase.title", {{"login", words.login}});
  Dialog shown = form_dialog(ui, title, ui.text("people.erase.act"), {fault, is_busy}, form_height);
  shown.keep = ui.text("people.keep");
  shown.sentence = ui.text("people.erase.sentence");
  shown.is_dangerous = true;
  return dialog(ui, "people.erase", shown,
                [&](const Rect& form) { return draw_fields(ui, form, words); });
}

}  // namespace hallux::ui
