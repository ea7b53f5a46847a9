// Editing as functions of text and cursor. A key is one step back for Ctrl+Z, letters in a row are
// one together. Places are byte offsets that always lie between two letters, so that no edit tears
// one. A secret keeps no past and gives nothing to the clipboard.
#include "ui/widgets/texts/text_edit.h"

#include "ui/widgets/texts/text_layout.h"
#include "ui/widgets/texts/wipe.h"

namespace hallux::ui {
namespace {

constexpr std::size_t max_past = 100;

// A secret has no past: what was undone would stay in memory.
void remember(TextEdit& edit, std::string& text, bool is_typing, const EditRules& rules) {
  if (rules.is_secret) {
    make_room_for_secret(text, rules.max_bytes);
    return;
  }
  if (is_typing && edit.is_typing) return;
  edit.past.push_back({text, edit.cursor});
  if (edit.past.size() > max_past) edit.past.erase(edit.past.begin());
  edit.undone.clear();
  edit.is_typing = is_typing;
}

void erase(TextEdit& edit, std::string& text, std::size_t begin, std::size_t end) {
  text.erase(begin, end - begin);
  edit.cursor = {begin, begin};
}

void erase_selection(TextEdit& edit, std::string& text) {
  erase(edit, text, edit.cursor.begin(), edit.cursor.end());
}

bool is_space(std::string_view text, std::size_t place) {
  return text[place] == ' ' || text[place] == '\n';
}

std::size_t word_before(std::string_view text, std::size_t place) {
  while (place > 0 && is_space(text, place - 1)) --place;
  while (place > 0 && !is_space(text, place - 1)) --place;
  return place;
}

std::size_t word_after(std::string_view text, std::size_t place) {
  while (place < text.size() && !is_space(text, place)) ++place;
  while (place < text.size() && is_space(text, place)) ++place;
  return place;
}

void erase_towards(TextEdit& edit, std::string& text, std::size_t place, const EditRules& rules) {
  if (!edit.cursor.has_selection() && place == edit.cursor.caret) return;
  remember(edit, text, false, rules);
  if (!edit.cursor.has_selection()) edit.cursor.anchor = place;
  erase_selection(edit, text);
}

void go(TextEdit& edit, std::string& text, std::vector<TextEdit::Past>& from,
        std::vector<TextEdit::Past>& to) {
  if (from.empty()) return;
  to.push_back({text, edit.cursor});
  text = from.back().text;
  edit.cursor = from.back().cursor;
  from.pop_back();
  edit.is_typing = false;
}

void copy(const TextEdit& edit, const std::string& text, const EditRules& rules,
          Clipboard& clipboard) {
  if (!edit.cursor.has_selection() || rules.is_secret) return;
  clipboard.write(
      std::string_view(text).substr(edit.cursor.begin(), edit.cursor.end() - edit.cursor.begin()));
}

void paste(TextEdit& edit, std::string& text, const EditRules& rules, Clipboard& clipboard) {
  std::string pasted = clipboard.read();
  insert_text(edit, text, pasted, rules);
  if (rules.is_secret) wipe(pasted);
}

bool press_control_key(TextEdit& edit, std::string& text, Chord chord, const EditRules& rules,
                       Clipboard& clipboard) {
  switch (chord.key) {
    case Key::A:
      edit.cursor = {text.size(), 0};
      return true;
    case Key::C:
      copy(edit, text, rules, clipboard);
      return true;
    case Key::X:
      copy(edit, text, rules, clipboard);
      if (edit.cursor.has_selection() && !rules.is_secret)
        erase_towards(edit, text, edit.cursor.caret, rules);
      return true;
    case Key::V:
      paste(edit, text, rules, clipboard);
      return true;
    case Key::Z:
      if (chord.modifiers.shift)
        go(edit, text, edit.undone, edit.past);
      else
        go(edit, text, edit.past, edit.undone);
      return true;
    case Key::Y:
      go(edit, text, edit.undone, edit.past);
      return true;
    default:
      return false;
  }
}

// The ends of the line that the caret is in; the whole text in a single-line field.
std::size_t line_begin(std::string_view text, std::size_t place) {
  const std::size_t found = place == 0 ? std::string_view::npos : text.rfind('\n', place - 1);
  return found == std::string_view::npos ? 0 : found + 1;
}
std::size_t line_end(std::string_view text, std::size_t place) {
  const std::size_t found = text.find('\n', place);
  return found == std::string_view::npos ? text.size() : found;
}

}  // namespace

void keep_cursor_inside(TextEdit& edit, std::string_view text) noexcept {
  for (std::size_t* place : {&edit.cursor.caret, &edit.cursor.anchor}) {
    if (*place > text.size()) *place = text.size();
    if (*place < text.size() && (static_cast<unsigned char>(text[*place]) & 0xC0U) == 0x80U)
      *place = previous_place(text, *place);
  }
}

void type_character(TextEdit& edit, std::string& text, char32_t character, const EditRules& rules) {
  if (character < 0x20 || character == 0x7F) return;
  std::string typed;
  append_code_point(typed, character);
  if (text.size() - (edit.cursor.end() - edit.cursor.begin()) + typed.size() > rules.max_bytes)
    return;
  remember(edit, text, !edit.cursor.has_selection(), rules);
  erase_selection(edit, text);
  text.insert(edit.cursor.caret, typed);
  edit.cursor.caret += typed.size();
  edit.cursor.anchor = edit.cursor.caret;
}

void insert_text(TextEdit& edit, std::string& text, std::string_view inserted,
                 const EditRules& rules) {
  if (inserted.empty()) return;
  remember(edit, text, false, rules);
  erase_selection(edit, text);
  std::string kept;
  if (rules.is_secret) kept.reserve(rules.max_bytes);
  for (std::size_t place = 0; place < inserted.size();) {
    char32_t letter = next_code_point(inserted, place);
    if (letter == U'\n' && !rules.is_multiline) letter = U' ';
    if ((letter < 0x20 && letter != U'\n') || letter == 0x7F) continue;
    std::string encoded;
    append_code_point(encoded, letter);
    if (text.size() + kept.size() + encoded.size() > rules.max_bytes) break;
    kept += encoded;
  }
  text.insert(edit.cursor.caret, kept);
  edit.cursor.caret += kept.size();
  edit.cursor.anchor = edit.cursor.caret;
  if (rules.is_secret) wipe(kept);
}

void move_caret(TextEdit& edit, std::size_t place, bool is_selecting) noexcept {
  edit.cursor.caret = place;
  if (!is_selecting) edit.cursor.anchor = place;
  edit.is_typing = false;
}

void select_word(TextEdit& edit, std::string_view text, std::size_t place) noexcept {
  std::size_t begin = place, end = place;
  while (begin > 0 && !is_space(text, begin - 1)) --begin;
  while (end < text.size() && !is_space(text, end)) ++end;
  edit.cursor = {end, begin};
}

bool press_edit_key(TextEdit& edit, std::string& text, Chord chord, const EditRules& rules,
                    Clipboard& clipboard) {
  const bool by_word = chord.modifiers.control, is_selecting = chord.modifiers.shift;
  const std::size_t caret = edit.cursor.caret;
  const bool collapses = edit.cursor.has_selection() && !is_selecting && !by_word;
  switch (chord.key) {
    case Key::Left:
      move_caret(edit,
                 collapses ? edit.cursor.begin()
                 : by_word ? word_before(text, caret)
                           : previous_place(text, caret),
                 is_selecting);
      return true;
    case Key::Right:
      move_caret(edit,
                 collapses ? edit.cursor.end()
                 : by_word ? word_after(text, caret)
                           : following_place(text, caret),
                 is_selecting);
      return true;
    case Key::Home:
      move_caret(edit, by_word ? 0 : line_begin(text, caret), is_selecting);
      return true;
    case Key::End:
      move_caret(edit, by_word ? text.size() : line_end(text, caret), is_selecting);
      return true;
    case Key::Backspace:
      erase_towards(edit, text, by_word ? word_before(text, caret) : previous_place(text, caret),
                    rules);
      return true;
    case Key::Delete:
      erase_towards(edit, text, by_word ? word_after(text, caret) : following_place(text, caret),
                    rules);
      return true;
    case Key::Enter:
      if (!rules.is_multiline || by_word) return false;
      insert_text(edit, text, "\n", rules);
      return true;
    default:
      return by_word && press_control_key(edit, text, chord, rules, clipboard);
  }
}

}  // namespace hallux::ui
