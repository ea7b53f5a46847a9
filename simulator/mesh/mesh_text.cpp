#include "simulator/mesh/mesh_text.h"

#include <array>
#include <charconv>
#include <cmath>

namespace hallux::simulator {

namespace {

bool is_blank(char letter) noexcept {
  return letter == ' ' || letter == '\t' || letter == '\r' || letter == '\v' || letter == '\f';
}

std::string tenth_text(double value) {
  std::array<char, 400> buffer{};
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                    std::chars_format::fixed, 1);
  return {buffer.data(), result.ptr};
}

/// from_chars knows no plus sign.
std::string_view without_plus(std::string_view word) noexcept {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

std::size_t length_of_word(std::string_view text) noexcept {
  std::size_t length = 0;
  while (length < text.size() && !is_blank(text[length]) && text[length] != '\n') ++length;
  return length;
}

}  // namespace

void refuse_mesh(std::string_view name, const std::string& what) {
  throw MeshError(std::string{name} + ": " + what);
}

void refuse_not_finite(std::string_view name, const std::string& which) {
  refuse_mesh(name, which +
                        " has a coordinate that is not a finite number; repair the mesh and "
                        "export it again");
}

std::string place_text(const Vec3& point_mm) {
  return tenth_text(point_mm.x) + " " + tenth_text(point_mm.y) + " " + tenth_text(point_mm.z) +
         " mm";
}

std::string quoted(std::string_view word) {
  constexpr std::size_t longest = 24;
  std::string text = "'";
  for (const char letter : word.substr(0, longest)) {
    text.push_back(letter >= ' ' && letter <= '~' ? letter : '?');
  }
  return text + (word.size() > longest ? "...'" : "'");
}

bool is_keyword(std::string_view word, std::string_view lower) noexcept {
  if (word.size() != lower.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char letter =
        word[i] >= 'A' && word[i] <= 'Z' ? static_cast<char>(word[i] + 32) : word[i];
    if (letter != lower[i]) return false;
  }
  return true;
}

std::string_view TextCursor::word() noexcept {
  std::size_t at = 0;
  while (at < rest_.size() && (is_blank(rest_[at]) || rest_[at] == '\n')) {
    if (rest_[at] == '\n') ++line_;
    ++at;
  }
  rest_.remove_prefix(at);
  const std::string_view found = rest_.substr(0, length_of_word(rest_));
  rest_.remove_prefix(found.size());
  return found;
}

std::string_view TextCursor::word_in_line() noexcept {
  std::size_t at = 0;
  while (at < rest_.size()) {
    const std::size_t crlf = rest_.compare(at, 3, "\\\r\n") == 0 ? 3 : 0;
    const std::size_t joined = rest_.compare(at, 2, "\\\n") == 0 ? 2 : crlf;
    if (joined == 0 && !is_blank(rest_[at])) break;
    if (joined != 0) ++line_;
    at += joined != 0 ? joined : 1;
  }
  rest_.remove_prefix(at);
  const std::string_view found = rest_.substr(0, length_of_word(rest_));
  rest_.remove_prefix(found.size());
  return found;
}

void TextCursor::skip_line() noexcept {
  const std::size_t end = rest_.find('\n');
  if (end == std::string_view::npos) {
    rest_ = {};
    return;
  }
  rest_.remove_prefix(end + 1);
  ++line_;
}

void TextCursor::expect(std::string_view keyword) {
  const std::string_view found = word();
  if (is_keyword(found, keyword)) return;
  if (found.empty())
    refuse("the file ends where " + quoted(keyword) +
           " should stand; it is cut short, export it again");
  refuse(quoted(found) + " stands where " + quoted(keyword) + " should; export the file again");
}

double TextCursor::number(std::string_view word) const {
  if (word.empty())
    refuse("a number is missing; the file is cut short or damaged, export it again");
  const std::string_view digits = without_plus(word);
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range || end != digits.data() + digits.size() ||
      error != std::errc{}) {
    refuse(quoted(word) + " is not a number; export the file again");
  }
  if (!std::isfinite(value)) {
    refuse(quoted(word) + " is not a finite number; repair the mesh and export it again");
  }
  return value;
}

std::int64_t TextCursor::whole_number(std::string_view word) const {
  if (word.empty())
    refuse("a number is missing; the file is cut short or damaged, export it again");
  const std::string_view digits = without_plus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size()) {
    refuse(quoted(word) + " is not a whole number; export the file again");
  }
  return value;
}

void TextCursor::refuse(const std::string& what) const {
  refuse_mesh(name_, "line " + std::to_string(line_) + ": " + what);
}

}  // namespace hallux::simulator
