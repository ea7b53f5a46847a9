#include "ui/screens/parts/message_form.h"

#include <utility>

#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/dialog.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {

namespace {

constexpr float words_height = 104.0F, toggle_height = 24.0F, gap = 16.0F;

}  // namespace

MessageFormSpec question_form(const Ui& ui, std::string_view title, std::string_view sentence) {
  return {.id = "ask",
          .title = title,
          .sentence = sentence,
          .label = ui.text("result.ask.question"),
          .placeholder = ui.text("result.ask.example"),
          .act = ui.text("result.ask.send"),
          .sending = ui.text("result.ask.sending"),
          .sent = ui.text("result.ask.sent")};
}

void MessageForm::open() {
  is_open_ = true;
  is_on_ = false;
  words_.clear();
  work_.forget_fault();
}

void MessageForm::start(Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
                        const MessageFormSpec& spec, const Send& send) {
  work_.change(
      shell, signed_in, {std::string(spec.sending), {}},
      [send, words = words_, is_on = is_on_](database::Session& session) {
        send(session, words, is_on);
      },
      [this, &shell, sent = std::string(spec.sent)] {
        is_open_ = false;
        was_sent_ = true;
        shell.say({Meaning::Good, sent});
      });
}

bool MessageForm::draw(Ui& ui, Shell& shell, const std::shared_ptr<SignedInSession>& signed_in,
                       const MessageFormSpec& spec, const Send& send) {
  if (std::exchange(was_sent_, false)) return true;
  if (!is_open_) return false;
  const std::string id(spec.id);
  Dialog shown = form_dialog(ui, spec.title, spec.act, {work_.fault(), work_.is_running()},
                             field_label_height + words_height);
  shown.sentence = spec.sentence;
  if (!spec.toggle.empty()) shown.form_height += gap + toggle_height;
  const Answer answer = dialog(ui, id, shown, [&](const Rect& form) {
    Rect rest = form;
    take_top(rest, field_label_height);
    FieldSpec words{
        .label = spec.label, .placeholder = spec.placeholder, .lines = 4, .max_bytes = 2000};
    field(ui, id + ".words", take_top(rest, words_height, gap), words_, words);
    ui.focus_first(id + ".words");
    if (!spec.toggle.empty())
      toggle(ui, id + ".toggle", take_top(rest, toggle_height), spec.toggle, is_on_);
    return words_.empty() ? ui.text("form.missing.words") : std::string_view();
  });
  if (answer == Answer::Keep) is_open_ = false;
  if (answer == Answer::Act && !work_.is_running()) start(shell, signed_in, spec, send);
  return false;
}

}  // namespace hallux::ui
