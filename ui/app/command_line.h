/// The whole command line of `hallux`, from arguments to exit code.
#pragma once

#include <iosfwd>

#include "ui/app/terminal/exit_code.h"

namespace hallux::ui {

ExitCode run_command_line(int argc, const char* const* argv, std::istream& in, std::ostream& out,
                          std::ostream& err);

}  // namespace hallux::ui
