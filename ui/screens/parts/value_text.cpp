#include "ui/screens/parts/value_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <vector>

#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {

std::string points_text(std::int64_t milli) {
  const std::int64_t tenths = (milli + (milli < 0 ? -50 : 50)) / 100;
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%lld.%lld", static_cast<long long>(tenths / 10),
                static_cast<long long>(tenths < 0 ? -(tenths % 10) : tenths % 10));
  return text.data();
}

std::string moment_text(std::string_view utc) {
  constexpr std::array<const char*, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                               "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  int year = 0, month = 0, day = 0, hour = 0, minute = 0;
  const std::string whole(utc);
  if (std::sscanf(whole.c_str(), "%4d-%2d-%2dT%2d:%2d", &year, &month, &day, &hour, &minute) != 5 ||
      month < 1 || month > 12) {
    return whole;
  }
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%d %s %d, %02d:%02d", day,
                months[static_cast<std::size_t>(month - 1)], year, hour, minute);
  return text.data();
}

std::string sentence_of(std::string_view reason) {
  std::string sentence(reason);
  if (sentence.empty()) return sentence;
  const auto first = static_cast<unsigned char>(sentence.front());
  if (first < 0x80) sentence.front() = static_cast<char>(std::toupper(first));
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
    const bool is_part = !is_plain || std::isalnum(static_cast<int>(letter)) != 0;
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
