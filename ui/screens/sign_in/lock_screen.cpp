#include "ui/screens/sign_in/lock_screen.h"

#include <algorithm>
#include <utility>

#include "ui/screens/parts/page.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {

namespace {

constexpr float form_width = 360.0F, form_height = 420.0F;

/// Of one try; it may outlive the screen.
struct Try {
  database::SecretText password;
  SignInWait wait;
};

}  // namespace

LockScreen::LockScreen(std::shared_ptr<SignedInSession> signed_in, std::function<void()> sign_out,
                       database::PasswordCost cost)
    : signed_in_(std::move(signed_in)), sign_out_(std::move(sign_out)), cost_(cost) {}

LockScreen::~LockScreen() { wipe(password_); }

void LockScreen::draw(Ui& ui, const Rect& content, Shell& shell) {
  if (since_s_ < 0.0) since_s_ = ui.time_s();
  const double left_s = since_s_ + longest_s - ui.time_s();
  if (left_s <= 0.0) return sign_out_();
  ui.want_frame_in_s(left_s);
  const float width = std::min(form_width, content.w - 2.0F * space::page);
  draw_form(ui, centred(content, width, std::min(form_height, content.h)), shell);
}

void LockScreen::draw_form(Ui& ui, Rect column, Shell& shell) {
  const Theme& theme = ui.theme();
  const database::Person& person = signed_in_->person();
  const bool is_recording = shell.top() != nullptr && !shell.top()->why_not_leave().empty();
  const std::string sentence =
      ui.texts().say(is_recording ? "lock.sentence.recording" : "lock.sentence",
                     {{"name", person.display_name.empty() ? person.login : person.display_name}});
  ui.canvas().text_in(take_top(column, 40.0F, 4.0F), {Type::Title, theme.text},
                      ui.text("lock.title"));
  text_line(ui, column, Type::Body, theme.text_secondary, sentence, 24.0F);
  labelled_field(ui, "lock.password", column, password_,
                 {.label = ui.text("entry.password"),
                  .is_secret = true,
                  .why_off = work_.is_running() ? ui.text("button.busy") : std::string_view()},
                 entry_field_gap);
  ui.focus_first("lock.password");
  wait_.draw_fault(ui, column, fault_);
  ButtonSpec open_it{ui.text("lock.open"), ButtonLook::Primary, Icon::Lock};
  if (password_.empty()) open_it.why_off = ui.text("entry.missing.password");
  if (wait_.left_s(ui) > 0) open_it.why_off = ui.text("entry.missing.wait");
  open_it.is_busy = work_.is_running();
  if (button(ui, "lock.open", take_top(column, large_button_height, 20.0F), open_it)) {
    open(ui, shell);
  }
  if (is_recording) return;
  if (link(ui, "lock.other", {column.x, column.y + 10.0F}, ui.text("lock.other"))) sign_out_();
}

void LockScreen::open(Ui& ui, Shell& shell) {
  auto tried = std::make_shared<Try>(Try{database::SecretText::take(password_), {}});
  fault_.clear();
  work_.start(
      shell, std::string(ui.text("lock.opening")),
      [tried, signed_in = signed_in_, cost = cost_](WorkReport&) {
        tried->wait.noting([&] {
          signed_in->in_turn([&](database::Session& session, database::Database&) {
            session.prove(tried->password, cost);
          });
        });
      },
      [this, &shell, tried](WorkEnd end, const std::string& reason) {
        if (end == WorkEnd::Done) return shell.unlock();
        wait_ = tried->wait;
        fault_ = sentence_of(reason);
      });
}

}  // namespace hallux::ui
