/// Every text people read, in one catalogue: an id gives a whole sentence, never a piece of one.
///
/// The catalogue is a file of lines `id = text`; `#` begins a comment, `\n` in a text is a new
/// line. A text may hold named places in braces, `{score} of 100`, which say() fills. A text that
/// depends on a number comes as two lines, `id.one` and `id.other`, which say_count() chooses from.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hallux::ui {

/// Values for the named places of a text.
using TextValues = std::vector<std::pair<std::string_view, std::string>>;

class Texts {
 public:
  /// errors  std::runtime_error naming line and fault: no `=`, an empty text, an id twice, a brace
  ///         left open
  explicit Texts(std::string_view catalogue);

  /// The text with this id; "[missing text]" where there is none, so that a fault is seen and found
  /// by the tests.
  std::string_view text(std::string_view id) const;
  /// The text with its named places filled; a place without a value stays in braces.
  std::string say(std::string_view id, const TextValues& values) const;
  /// `id.one` for 1, else `id.other`; `{count}` is filled with the number in thin groups: 14 000.
  std::string say_count(std::string_view id, long count, const TextValues& values = {}) const;

  std::vector<std::string> ids() const;

 private:
  std::map<std::string, std::string, std::less<>> texts_;
};

/// The catalogue that ships.
Texts english_texts();

/// A whole number in groups of three: 14 000.
std::string grouped(long number);

}  // namespace hallux::ui
