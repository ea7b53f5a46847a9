/// The window while nobody touches it: who is signed in opens it with their password; somebody else
/// may sign in where nothing is being recorded.
///
/// In a laboratory a station must neither show what a trainee left open nor lose what they record.
/// So the operation is paused and kept for the one who began it, and after twelve hours it ends as
/// interrupted and the station is free.
/// source  OWASP ASVS 4.0.3, 3.3.2; docs/security.md
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ui/screens/parts/screen_work.h"
#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/parts/value_text.h"
#include "ui/screens/sign_in/sign_in_wait.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class LockScreen : public Screen {
 public:
  static constexpr double longest_s = 12.0 * 60.0 * 60.0;

  /// `sign_out` ends the session and unlocks.
  LockScreen(std::shared_ptr<SignedInSession> signed_in, std::function<void()> sign_out,
             database::PasswordCost cost = {});
  ~LockScreen() override;

  GuideSection guide_section() const override { return GuideSection::LeftOpen; }
  WindowChrome surround() const override { return WindowChrome::Nothing; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  void draw_form(Ui& ui, Rect column, Shell& shell);
  void open(Ui& ui, Shell& shell);

  std::shared_ptr<SignedInSession> signed_in_;
  std::function<void()> sign_out_;
  database::PasswordCost cost_;
  std::string password_, fault_;
  double since_s_ = -1.0;
  SignInWait wait_;
  ScreenWork work_;
};

}  // namespace hallux::ui
