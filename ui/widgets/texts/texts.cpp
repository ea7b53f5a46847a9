#include "ui/widgets/texts/texts.h"

#include <stdexcept>

#include "simulator/base/embedded.h"

namespace hallux::ui {

// The embedded files of CMakeLists.txt.
std::span<const EmbeddedText> text_files() noexcept;

namespace {

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

[[noreturn]] void refuse(int line, const std::string& fault) {
  throw std::runtime_error("The catalogue of texts, line " + std::to_string(line) + ": " + fault);
}

std::string with_new_lines(std::string_view text) {
  std::string result(text);
  for (auto at = result.find("\\n"); at != std::string::npos; at = result.find("\\n", at + 1))
    result.replace(at, 2, "\n");
  return result;
}

void check_braces(std::string_view text, int line) {
  bool is_open = false;
  for (const char letter : text) {
    if (letter == '{' && is_open) refuse(line, "a brace is opened twice");
    if (letter == '}' && !is_open) refuse(line, "a brace is closed that was not opened");
    if (letter == '{' || letter == '}') is_open = letter == '{';
  }
  if (is_open) refuse(line, "a brace is left open");
}

}  // namespace

Texts::Texts(std::string_view catalogue) {
  int number = 0;
  for (std::size_t begin = 0; begin < catalogue.size();) {
    ++number;
    auto end = catalogue.find('\n', begin);
    if (end == std::string_view::npos) end = catalogue.size();
    const std::string_view line = trimmed(catalogue.substr(begin, end - begin));
    begin = end + 1;
    if (line.empty() || line.front() == '#') continue;
    const auto equals = line.find('=');
    if (equals == std::string_view::npos) refuse(number, "has no '='; write id = text");
    const std::string_view id = trimmed(line.substr(0, equals)),
                           text = trimmed(line.substr(equals + 1));
    if (id.empty() || text.empty()) refuse(number, "has no id or no text");
    check_braces(text, number);
    if (!texts_.emplace(std::string(id), with_new_lines(text)).second)
      refuse(number, "'" + std::string(id) + "' is there twice");
  }
}

std::string_view Texts::text(std::string_view id) const {
  const auto found = texts_.find(id);
  if (found != texts_.end()) return found->second;
  return "[missing text]";
}

std::string Texts::say(std::string_view id, const TextValues& values) const {
  std::string result(text(id));
  for (const auto& [name, value] : values) {
    const std::string place = "{" + std::string(name) + "}";
    for (auto at = result.find(place); at != std::string::npos;
         at = result.find(place, at + value.size()))
      result.replace(at, place.size(), value);
  }
  return result;
}

std::string Texts::say_count(std::string_view id, long count, const TextValues& values) const {
  TextValues all = values;
  all.emplace_back("count", grouped(count));
  return say(std::string(id) + (count == 1 ? ".one" : ".other"), all);
}

std::vector<std::string> Texts::ids() const {
  std::vector<std::string> result;
  for (const auto& [id, text] : texts_) result.push_back(id);
  return result;
}

Texts english_texts() { return Texts(text_files().front().text); }

std::string grouped(long number) {
  std::string digits = std::to_string(number < 0 ? -number : number);
  for (std::size_t place = digits.size(); place > 3; place -= 3)
    digits.insert(place - 3, "\xE2\x80\x89");
  return number < 0 ? "\xE2\x88\x92" + digits : digits;
}

}  // namespace hallux::ui
