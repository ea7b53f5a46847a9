/// The dialogs of the people screen: adding a person, and the one-time code that is shown once.
#pragma once

#include <optional>
#include <string>

#include "database/administrator_desk.h"
#include "ui/widgets/menu.h"

namespace hallux::ui {

/// What is typed of a new person; it stays while a refusal is read.
struct AddedPersonWords {
  std::string login, display_name;
  bool is_administrator = false;
};

/// Asks who is added. `fault` says why the last try failed.
Answer draw_add_dialog(Ui& ui, AddedPersonWords& words, const std::string& fault, bool is_busy);

/// A code that was just issued. It is drawn but not noted with the texts of the frame, and wiped with this.
struct ShownCode {
  std::string whose;  ///< login
  database::IssuedCode issued;
};
enum class CodeAnswer { Waiting, Copied, Done };
CodeAnswer draw_code_dialog(Ui& ui, const ShownCode& code);

}  // namespace hallux::ui
