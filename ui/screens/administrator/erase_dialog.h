/// The dialog before a person is erased: what goes, what stays, and that it is meant.
/// Inside this corner only.
#pragma once

#include <string>

#include "ui/widgets/controls/menu.h"

namespace hallux::ui {

/// What is typed before somebody is erased; wiped when it goes.
struct EraseWords {
  /// Of whom.
  std::string login;
  std::string typed_login, reason, password;
  bool with_recordings = false;
  explicit EraseWords(std::string of) : login(std::move(of)) {}
  EraseWords(const EraseWords&) = delete;
  EraseWords& operator=(const EraseWords&) = delete;
  ~EraseWords();
};

/// Asks for their login, a reason and the administrator's own password. `fault` says why the last
/// try failed.
Answer draw_erase_dialog(Ui& ui, EraseWords& words, const std::string& fault, bool is_busy);

}  // namespace hallux::ui
