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
  /// Full, read-only or damaged.
  Storage = 6,
  /// Needs a display or device that is not there.
  NoDisplay = 7
};

}  // namespace hallux::ui
