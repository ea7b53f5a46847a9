/// The sheets of the people screen: adding a person, and the one-time code that is shown once.
#pragma once

#include <optional>
#include <string>

#include "database/administrator_desk.h"
#include "ui/widgets/ui.h"

namespace hallux::ui {

/// What is typed of a new person; it stays while a refusal is read.
struct AddedPersonWords {
  std::string login, display_name;
  bool is_administrator = false;
};

enum class SheetAnswer { Waiting, Done, Closed };

/// Asks who is added. Done where the person wants them added. `fault` is shown at the login.
SheetAnswer draw_add_sheet(Ui& ui, AddedPersonWords& words, const std::string& fault, bool is_busy);

/// A code that was just issued. It is drawn but not noted with the texts of the frame, and wiped with this.
struct ShownCode {
  std::string whose;  ///< login
  database::IssuedCode issued;
};
enum class CodeAnswer { Waiting, Copied, Done };
CodeAnswer draw_code_sheet(Ui& ui, const ShownCode& code);

}  // namespace hallux::ui
