#include "ui/screens/parts/value_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <vector>

#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {

namespace {

/// Beyond ASCII: punctuation, arrows, pictures, letters for private use. A name may hold them, but
/// no word of it begins with one.
constexpr bool is_sign(char32_t letter) noexcept {
  return letter < 0xC0 || letter == 0xD7 || letter == 0xF7 ||
         (letter >= 0x2000 && letter < 0x2C00) || (letter >= 0x3000 && letter < 0x3040) ||
         (letter >= 0xE000 && letter < 0xF900) || (letter >= 0xFE00 && letter < 0xFE10) ||
         (letter >= 0xFFF0 && letter < 0x10000) || (letter >= 0x1F000 && letter < 0x20000);
}

/// The name of a file or of something in it stays as it is written: "bad.json", "rubric_item".
bool begins_with_name(std::string_view sentence) noexcept {
  const std::string_view word = sentence.substr(0, sentence.find(' '));
  return word.substr(0, word.size() - 1).find_first_of("./_\\") != std::string_view::npos;
}

}  // namespace

std::string points_text(std::int64_t milli) {
  const std::int64_t tenths = (milli + (milli < 0 ? -50 : 50)) / 100;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%lld.%lld", static_cast<long long>(tenths / 10),
                static_cast<long long>(tenths < 0 ? -(tenths % 10) : tenths % 10));
  return text.data();
}

std::string sentence_of(std::string_view reason) {
  std::string sentence(reason);
  if (sentence.empty()) return sentence;
  const auto first = static_cast<unsigned char>(sentence.front());
  if (first < 0x80 && !begins_with_name(sentence))
    sentence.front() = static_cast<char>(std::toupper(first));
  if (std::string_view(".?").find(sentence.back()) == std::string_view::npos) sentence += '.';
  return sentence;
}

std::string file_name_text(std::string_view file_name) {
  std::string words(file_name);
  std::replace(words.begin(), words.end(), '_', ' ');
  return words;
}

std::string initials_of(std::string_view name) {
  std::vector<std::string> beginnings;
  bool is_word_begun = false;
  for (std::size_t place = 0; place < name.size();) {
    const char32_t letter = next_code_point(name, place);
    const bool is_plain = letter < 0x80;
    const bool is_part = is_plain ? std::isalnum(static_cast<int>(letter)) != 0 : !is_sign(letter);
    if (is_part && !is_word_begun) {
      append_code_point(
          beginnings.emplace_back(),
          is_plain ? static_cast<char32_t>(std::toupper(static_cast<int>(letter))) : letter);
    }
    is_word_begun = is_part;
  }
  if (beginnings.empty()) return {};
  return beginnings.front() + (beginnings.size() > 1 ? beginnings.back() : std::string());
}

}  // namespace hallux::ui
