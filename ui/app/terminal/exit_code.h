/// What the `hallux` command answers to the shell.
#pragma once

namespace hallux::ui {

enum class ExitCode : int {
  Done = 0,
  CheckFailed = 1,
  WrongUsage = 2,
  BadInput = 3,
  Refused = 4,
  Interrupted = 5,
  Storage = 6,   ///< full, read-only or damaged
  NoDisplay = 7  ///< needs a display or device that is not there
};

}  // namespace hallux::ui
