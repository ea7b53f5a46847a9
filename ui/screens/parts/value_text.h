/// Values as people read them: points, sentences, initials.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace hallux::ui {

/// Thousandths of a point with one decimal: 76 830 is "76.8".
std::string points_text(std::int64_t milli);

/// What an error says, which begins small behind the command's name, as a sentence of its own:
/// "Could not open it." A name at its beginning, of a file or of a part of it, stays as it is.
std::string sentence_of(std::string_view reason);

/// A name as files write it, as words: "first_metatarsal" is "first metatarsal".
std::string file_name_text(std::string_view file_name);

/// The first letter or digit of the first and of the last word, for an avatar: "trainee-12" is
/// "T1".
std::string initials_of(std::string_view name);

}  // namespace hallux::ui
