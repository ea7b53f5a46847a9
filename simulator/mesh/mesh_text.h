/// Reading text that nobody vouches for: words and numbers with their line, and sentences that
/// refuse a file. Inside this corner only.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "simulator/base/vector.h"
#include "simulator/mesh/mesh_error.h"

namespace hallux::simulator {

/// errors  always MeshError: "name: what"
[[noreturn]] void refuse_mesh(std::string_view name, const std::string& what);
/// errors  always MeshError, of a point that is no place; `which` begins the sentence
[[noreturn]] void refuse_not_finite(std::string_view name, const std::string& which);
/// "12.1 4.0 7.7 mm"
std::string place_text(const Vec3& point_mm);
/// The word as it may stand in a sentence: at most 24 characters, others than printable ones as
/// '?'.
std::string quoted(std::string_view word);

/// Walks through the words of a text. Never reads beyond its end; every step goes forward.
class TextCursor {
 public:
  /// `first_line` is the number of the text's first line in its file.
  TextCursor(std::string_view text, std::string_view name, std::size_t first_line = 1) noexcept
      : rest_(text), name_(name), line_(first_line) {}

  /// The next word in any line; empty at the end of the text.
  std::string_view word() noexcept;
  /// The next word in this line; empty at its end. A backslash before the line's end joins it with
  /// the next.
  std::string_view word_in_line() noexcept;
  void skip_line() noexcept;
  bool at_end() const noexcept { return rest_.empty(); }
  std::size_t bytes_left() const noexcept { return rest_.size(); }
  std::size_t line() const noexcept { return line_; }

  /// errors  MeshError where the word is not that keyword (in either case)
  void expect(std::string_view keyword);
  /// errors  MeshError where the word is no finite number
  double number(std::string_view word) const;
  double number() { return number(word()); }
  std::int64_t whole_number(std::string_view word) const;
  /// errors  always MeshError, with the line
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  std::string_view rest_;
  std::string_view name_;
  std::size_t line_;
};

/// Equal but for the case of ASCII letters; `lower` is in lower case.
bool is_keyword(std::string_view word, std::string_view lower) noexcept;

}  // namespace hallux::simulator
