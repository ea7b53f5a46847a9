/// The dialogs about people: adding a person, the one-time code that is shown once, one's own new
/// password.
#pragma once

#include <optional>
#include <string>

#include "database/desks/administrator_desk.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

/// What is typed of a new person; it stays while a refusal is read.
struct AddedPersonWords {
  std::string login, display_name;
  bool is_administrator = false;
};

/// Asks who is added. `fault` says why the last try failed.
Answer draw_add_dialog(Ui& ui, AddedPersonWords& words, const std::string& fault, bool is_busy);

/// What is typed to change one's password; wiped when it goes.
struct PasswordWords {
  std::string old_password, new_password, new_password_again;
  PasswordWords() = default;
  PasswordWords(const PasswordWords&) = delete;
  PasswordWords& operator=(const PasswordWords&) = delete;
  ~PasswordWords();
};

/// Asks for the old password and twice for the new one. `fault` says why the last try failed.
Answer draw_password_dialog(Ui& ui, PasswordWords& words, const std::string& fault, bool is_busy);

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
