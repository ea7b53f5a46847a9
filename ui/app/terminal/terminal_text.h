/// Text that others chose (file names, texts of files), made fit for a terminal and for JSON.
#pragma once

#include <string>
#include <string_view>

namespace hallux::ui {

/// Whether all of it is well-formed UTF-8: no stray bytes, no surrogates, nothing in a longer form
/// than needed.
bool is_utf8(std::string_view text) noexcept;

/// The same on one line that commands no terminal: control characters (C0, DEL, C1) and bytes that
/// are not UTF-8 are written as \x1b.
std::string terminal_text(std::string_view text);

}  // namespace hallux::ui
