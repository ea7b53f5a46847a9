/// Overwriting texts that held a secret.
#pragma once

#include <string>

namespace hallux::ui {

/// Empties `text`; all that it had room for is overwritten before.
void wipe(std::string& text) noexcept;

/// Gives a secret all the room it will ever need, so that it never moves and leaves no copy behind.
void make_room_for_secret(std::string& text, std::size_t max_bytes);

}  // namespace hallux::ui
