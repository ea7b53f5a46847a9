/// A verb that will not do what it was asked, as one sentence: what, where, and the mend.
#pragma once

#include <stdexcept>
#include <string>

#include "ui/app/terminal/exit_code.h"

namespace hallux::ui {

class VerbError : public std::runtime_error {
 public:
  VerbError(ExitCode code, const std::string& sentence)
      : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const noexcept { return code_; }

 private:
  ExitCode code_;
};

}  // namespace hallux::ui
