/// Text that others chose (file names, texts of files), made fit for a terminal.
#pragma once

#include <string>
#include <string_view>

namespace hallux::ui {

/// Text on one line that commands no terminal: control characters (C0, DEL, C1), marks that turn
/// the direction of writing and bytes that are not UTF-8 are written as \x1b.
std::string terminal_text(std::string_view text);

}  // namespace hallux::ui
