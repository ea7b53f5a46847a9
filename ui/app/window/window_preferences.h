/// What people chose for the window - theme, scale, sound - from one start to the next:
/// `window.json` beside the database. Inside this corner only.
#pragma once

#include <filesystem>
#include <string>

#include "ui/window/shell/shell.h"

namespace hallux::ui {

/// What is kept in the data directory; the usual ones where nothing is.
/// errors  FileRefused where the file cannot be read or is no such file; where one value is not
///         ours, that one is usual
Preferences read_preferences(const std::filesystem::path& data_directory);

/// Keeps them there, whole or not at all; nothing where no course is there yet.
/// errors  OutputError
void keep_preferences(const std::filesystem::path& data_directory, const Preferences& preferences);

/// Gives the shell what was kept, and keeps each change beside the window. A file that cannot be
/// read or written is said.
/// thread  window
class PreferenceKeeper {
 public:
  /// `texts` and `shell` outlive it.
  PreferenceKeeper(const Texts& texts, std::filesystem::path data_directory, Shell& shell);
  PreferenceKeeper(const PreferenceKeeper&) = delete;
  PreferenceKeeper& operator=(const PreferenceKeeper&) = delete;
  /// Lets the shell go; it must not be drawing.
  ~PreferenceKeeper();

 private:
  void keep(const Preferences& preferences);

  const Texts& texts_;
  std::filesystem::path data_directory_;
  Shell& shell_;
  bool is_writing_ = false;
  Preferences wanted_, written_;
};

}  // namespace hallux::ui
