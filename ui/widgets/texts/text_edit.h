/// Editing one text: caret, selection, undo, as plain data and functions without a screen.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "ui/widgets/input/input_event.h"

namespace hallux::ui {

/// Where a field is edited. Places are byte offsets between two letters of the text.
struct TextCursor {
  std::size_t caret = 0;
  /// The other end of the selection; equal to the caret where nothing is selected.
  std::size_t anchor = 0;

  bool has_selection() const noexcept { return caret != anchor; }
  std::size_t begin() const noexcept { return caret < anchor ? caret : anchor; }
  std::size_t end() const noexcept { return caret < anchor ? anchor : caret; }
};

/// What a field remembers between two frames, and what Ctrl+Z goes back to.
struct TextEdit {
  struct Past {
    std::string text;
    TextCursor cursor;
  };
  TextCursor cursor;
  std::vector<Past> past = {}, undone = {};
  /// Letters typed in a row are undone together.
  bool is_typing = false;
  /// A secret whose letters are shown.
  bool is_revealed = false;
  float scrolled_x = 0.0F,
        /// Logical pixels that the text is moved to keep the caret in sight.
      scrolled_y = 0.0F;
};

struct EditRules {
  std::size_t max_bytes = 200;
  /// Enter makes a new line.
  bool is_multiline = false;
  /// Nothing of it may be copied or undone, and no copy stays in memory.
  bool is_secret = false;
};

/// The text that the rest of the desktop shares with us.
class Clipboard {
 public:
  virtual ~Clipboard() = default;
  virtual std::string read() = 0;
  virtual void write(std::string_view text) = 0;
};

/// Puts the cursor inside `text` and at the beginning of a letter, whatever was done to the text
/// meanwhile.
void keep_cursor_inside(TextEdit& edit, std::string_view text) noexcept;

/// Types one character over the selection; controls and what exceeds `max_bytes` are left out.
/// ensures text stays valid UTF-8
void type_character(TextEdit& edit, std::string& text, char32_t character, const EditRules& rules);

/// Puts `inserted` in place of the selection; newlines become spaces unless the field has lines.
void insert_text(TextEdit& edit, std::string& text, std::string_view inserted,
                 const EditRules& rules);

/// Does what the key means in a text: moving, selecting with Shift, deleting, Ctrl+A C X V Z Y.
/// True where it means anything; Up and Down in a multi-line field are the caller's, who knows
/// where the lines break.
bool press_edit_key(TextEdit& edit, std::string& text, Chord chord, const EditRules& rules,
                    Clipboard& clipboard);

/// Moves the caret, and the anchor with it unless `is_selecting`.
void move_caret(TextEdit& edit, std::size_t place, bool is_selecting) noexcept;

/// Selects the word around `place`, as a double click does.
void select_word(TextEdit& edit, std::string_view text, std::size_t place) noexcept;

}  // namespace hallux::ui
