/// The dialogs about people: adding a person, correcting a name, the one-time code that is shown
/// once, one's own new password, and the last question before a person is erased.
#pragma once

#include <optional>
#include <string>

#include "database/desks/administrator_desk.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

/// What is typed of a new person; it stays while a refusal is read.
struct NewPersonForm {
  std::string login, display_name;
  bool is_administrator = false;
};

/// Asks who is added. `fault` says why the last try failed.
Answer draw_add_dialog(Ui& ui, NewPersonForm& form, const std::string& fault, bool is_busy);

/// A name that is corrected.
struct NameForm {
  /// Whose.
  std::string login;
  std::string before, name;
};

/// Asks for the right name. `fault` says why the last try failed.
Answer draw_name_dialog(Ui& ui, NameForm& form, const std::string& fault, bool is_busy);

/// What is typed to change one's password; wiped when it goes.
struct PasswordForm {
  std::string old_password, new_password, new_password_again;
  PasswordForm() = default;
  PasswordForm(const PasswordForm&) = delete;
  PasswordForm& operator=(const PasswordForm&) = delete;
  ~PasswordForm();
};

/// Asks for the old password and twice for the new one. `fault` says why the last try failed.
Answer draw_password_dialog(Ui& ui, PasswordForm& form, const std::string& fault, bool is_busy);

/// What is typed before somebody is erased; wiped when it goes.
struct EraseForm {
  /// Of whom.
  std::string login;
  std::string typed_login, reason, password;
  bool with_recordings = false;
  explicit EraseForm(std::string of) : login(std::move(of)) {}
  EraseForm(const EraseForm&) = delete;
  EraseForm& operator=(const EraseForm&) = delete;
  ~EraseForm();
};

/// Asks for their login, a reason and the administrator's own password; says what goes and what
/// stays. `fault` says why the last try failed.
Answer draw_erase_dialog(Ui& ui, EraseForm& form, const std::string& fault, bool is_busy);

/// A code that was just issued. It is drawn but not noted with the texts of the frame, and wiped
/// with this.
struct ShownCode {
  /// Login.
  std::string whose;
  database::IssuedCode issued;
};
enum class CodeAnswer { Waiting, Copied, Done };
CodeAnswer draw_code_dialog(Ui& ui, const ShownCode& code);

}  // namespace hallux::ui
