/// What happens where the display goes away while the window is open: the desktop's session ended,
/// a remote one broke off.
#pragma once

namespace hallux::ui {

/// From now on a lost display ends the program with this exit code and one sentence, as nothing can
/// be drawn or asked any more; Xlib would end it from inside one of its calls with words nobody
/// understands. What was recorded is in the database up to the last half second; the next start
/// marks the attempt as interrupted.
/// needs   a window that was opened; displays that are not X11 are left alone
void end_where_display_is_lost(int exit_code) noexcept;

}  // namespace hallux::ui
