/// Rules of free text in notes, questions, answers and reasons. Inside this room only.
#pragma once

#include <cstddef>
#include <string_view>

namespace hallux::database {

inline constexpr std::size_t free_text_bytes_max = 4000;

/// `what` begins the sentence: "the note".
/// errors  DatabaseError BadInput where the text is blank, longer than 4000 bytes, or not UTF-8
void check_free_text(std::string_view what, std::string_view text);

}  // namespace hallux::database
