/// The first screen: sign in, come in with a one-time code, or, where there are no people yet, make
/// the first administrator.
#pragma once

#include <functional>

#include "ui/screens/parts/signed_in_session.h"
#include "ui/screens/pictures/patient_pictures.h"
#include "ui/screens/sign_in/sign_in_wait.h"
#include "ui/widgets/controls/field.h"
#include "ui/window/shell/shell.h"

namespace hallux::ui {

class SignInScreen : public Screen {
 public:
  /// Called once somebody came in.
  using Entered = std::function<void(Shell& shell, std::shared_ptr<SignedInSession> signed_in)>;

  /// `pictures`, where there are any, outlive the screen: the bone beside the form comes from them.
  SignInScreen(std::filesystem::path data_directory, Entered entered,
               database::PasswordCost cost = {}, PatientPictures* pictures = nullptr);
  /// Wipes what was typed.
  ~SignInScreen() override;

  GuideSection guide_section() const override {
    return is_without_people_ ? GuideSection::Begin : GuideSection::SignIn;
  }
  WindowChrome surround() const override { return WindowChrome::Nothing; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override;

 private:
  enum class Form { Opening, Unusable, SignIn, Code, FirstAdministrator };
  using Work = std::shared_ptr<SignedInSession> (*)(const std::filesystem::path&, const SignInForm&,
                                                    const database::PasswordCost&);

  void draw_bone(Ui& ui, const Rect& side, Shell& shell);
  void open(Ui& ui, Shell& shell);
  void show(Form form);
  void draw_opening(Ui& ui, const Rect& column, Shell& shell);
  void draw_form(Ui& ui, Rect column, Shell& shell);
  void draw_sign_in(Ui& ui, Rect& column, Shell& shell);
  void draw_code(Ui& ui, Rect& column, Shell& shell);
  void draw_first_administrator(Ui& ui, Rect& column, Shell& shell);
  void draw_head(Ui& ui, Rect& column, std::string_view title, std::string_view sentence) const;
  /// True where the text changed.
  bool draw_field(Ui& ui, Rect& column, std::string_view id, std::string& text,
                  FieldSpec spec) const;
  void sign_in_or_tell_of_code(Ui& ui, Shell& shell);
  void draw_fault(Ui& ui, Rect& column);
  bool draw_button(Ui& ui, Rect& column, std::string_view id, std::string_view label,
                   std::string_view missing);
  /// What the form that is shown still needs; empty: nothing.
  std::string_view missing(const Ui& ui) const;
  void come_in(Ui& ui, Shell& shell, Work work);
  void come_in_with_new_password(Ui& ui, Shell& shell, Work work);
  void forget_secrets();

  std::filesystem::path data_directory_;
  Entered entered_;
  database::PasswordCost cost_;
  PatientPictures* pictures_;
  /// Whose patient is beside the form.
  scenarios::Scenario pictured_;
  Form form_ = Form::Opening;
  /// Frame time; below 0: not begun.
  double opening_since_s_ = -1.0;
  bool is_without_people_ = false;
  /// When the form appeared: then the next field has the focus.
  bool is_login_known_ = false;
  bool is_busy_ = false;
  /// That the password looks like a one-time code.
  bool is_code_told_ = false;
  std::string login_, name_, code_, password_, password_again_;
  /// Why it did not go; a sentence.
  std::string fault_;
  /// Of `waiting_login_`: somebody else at the station need not wait.
  SignInWait wait_;
  std::string waiting_login_;
  /// Of the work that runs.
  SignInForm words_;
  /// The work's, until it ends.
  SignInWait told_;
  std::shared_ptr<SignedInSession> signed_in_;
};

}  // namespace hallux::ui
