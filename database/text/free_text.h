/// Rules of names, and of free text in notes, questions, answers and reasons.
/// Inside this room only.
#pragma once

#include <cstddef>
#include <string_view>

namespace hallux::database {

inline constexpr std::size_t free_text_bytes_max = 4000;

/// Of a person's or a cohort's name as it is shown.
inline constexpr std::size_t name_bytes_max = 200;

/// `what` begins the sentence: "the note".
/// errors  DatabaseError BadInput where the text is blank, longer than 4000 bytes, or not UTF-8
void check_free_text(std::string_view what, std::string_view text);
/// errors  DatabaseError BadInput where the name is longer than 200 bytes, not UTF-8, or holds
///         letters that nobody sees; one that is empty is good
void check_name(std::string_view what, std::string_view name);

}  // namespace hallux::database
