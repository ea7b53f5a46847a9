#include "ui/widgets/texts/text_edit.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {
namespace {

struct Editing {
  TextEdit edit;
  std::string text;
  EditRules rules;
  MemoryClipboard clipboard;

  Editing& type(std::string_view letters) {
    for (std::size_t place = 0; place < letters.size();)
      type_character(edit, text, next_code_point(letters, place), rules);
    return *this;
  }
  Editing& press(Key key, Modifiers modifiers = {}) {
    press_edit_key(edit, text, {key, modifiers}, rules, clipboard);
    return *this;
  }
};

TEST(TextEdit, TypesAtTheCaret) {
  Editing editing;
  editing.type("tranee").press(Key::Left).press(Key::Left).press(Key::Left).type("i");
  EXPECT_EQ(editing.text, "trainee");
}

TEST(TextEdit, MovesAndDeletesByWholeLetters) {
  Editing editing;
  editing.type("a\xC3\xBC\xE2\x82\xAC");  // a, u with dots, euro sign
  editing.press(Key::Backspace);
  EXPECT_EQ(editing.text, "a\xC3\xBC");
  editing.press(Key::Home).press(Key::Right).press(Key::Delete);
  EXPECT_EQ(editing.text, "a");
}

TEST(TextEdit, MovesAndDeletesByWords) {
  Editing editing;
  editing.type("one two  three").press(Key::Left, {.control = true}).type("-");
  EXPECT_EQ(editing.text, "one two  -three");
  editing.press(Key::Backspace, {.control = true});
  EXPECT_EQ(editing.text, "one two  three");
  editing.press(Key::Home).press(Key::Delete, {.control = true});
  EXPECT_EQ(editing.text, "two  three");
}

TEST(TextEdit, SelectionIsReplacedCopiedAndCut) {
  Editing editing;
  editing.type("hello world").press(Key::Left, {.shift = true, .control = true});
  editing.press(Key::C, {.control = true}).press(Key::Home).press(Key::V, {.control = true});
  EXPECT_EQ(editing.text, "worldhello world");
  editing.press(Key::A, {.control = true}).press(Key::X, {.control = true});
  EXPECT_EQ(editing.text, "");
  EXPECT_EQ(editing.clipboard.read(), "worldhello world");
}

TEST(TextEdit, ASecretIsNeverCopied) {
  Editing editing;
  editing.rules.is_secret = true;
  editing.type("geheim")
      .press(Key::A, {.control = true})
      .press(Key::C, {.control = true})
      .press(Key::X, {.control = true});
  EXPECT_EQ(editing.clipboard.read(), "");
  EXPECT_EQ(editing.text, "geheim");
}

TEST(TextEdit, ASecretHasNoPastAndNeverMoves) {
  Editing editing;
  editing.rules.is_secret = true;
  editing.type("g");
  const char* place = editing.text.data();
  editing.type("eheim, und noch viel laenger als ein kurzer Text");
  EXPECT_EQ(editing.text.data(), place);
  editing.press(Key::Backspace, {.control = true}).press(Key::Z, {.control = true});
  EXPECT_EQ(editing.text, "geheim, und noch viel laenger als ein kurzer ");
  EXPECT_TRUE(editing.edit.past.empty());
  EXPECT_TRUE(editing.edit.undone.empty());
}

TEST(TextEdit, LettersInARowAreUndoneTogether) {
  Editing editing;
  editing.type("abc").press(Key::Left).type("xy");
  EXPECT_EQ(editing.text, "abxyc");
  editing.press(Key::Z, {.control = true});
  EXPECT_EQ(editing.text, "abc");
  editing.press(Key::Z, {.control = true});
  EXPECT_EQ(editing.text, "");
  editing.press(Key::Z, {.shift = true, .control = true}).press(Key::Y, {.control = true});
  EXPECT_EQ(editing.text, "abxyc");
}

TEST(TextEdit, NewLinesOnlyWhereTheFieldHasLines) {
  Editing editing;
  EXPECT_FALSE(
      press_edit_key(editing.edit, editing.text, {Key::Enter}, editing.rules, editing.clipboard));
  insert_text(editing.edit, editing.text, "a\nb\x01", editing.rules);
  EXPECT_EQ(editing.text, "a b");
  editing.rules.is_multiline = true;
  editing.press(Key::Enter).type("c");
  EXPECT_EQ(editing.text, "a b\nc");
  editing.press(Key::Home).type("x");
  EXPECT_EQ(editing.text, "a b\nxc");
}

TEST(TextEdit, StopsAtItsLimitWithoutHalfALetter) {
  Editing editing;
  editing.rules.max_bytes = 4;
  editing.type("ab\xE2\x82\xAC");
  EXPECT_EQ(editing.text, "ab");
  insert_text(editing.edit, editing.text, "c\xE2\x82\xAC", editing.rules);
  EXPECT_EQ(editing.text, "abc");
}

bool is_utf8(std::string_view text) {
  for (std::size_t place = 0; place < text.size();)
    if (next_code_point(text, place) == 0xFFFD) return false;
  return true;
}

RC_GTEST_PROP(TextEdit, AnyKeysLeaveWholeLettersAndACursorInside, ()) {
  Editing editing;
  editing.rules.is_multiline = *rc::gen::arbitrary<bool>();
  editing.rules.max_bytes = *rc::gen::inRange<std::size_t>(0, 40);
  const int steps = *rc::gen::inRange(1, 60);
  for (int step = 0; step < steps; ++step) {
    const Modifiers modifiers{*rc::gen::arbitrary<bool>(), *rc::gen::arbitrary<bool>(), false};
    if (*rc::gen::arbitrary<bool>())
      type_character(editing.edit, editing.text,
                     *rc::gen::element<char32_t>(U'a', U' ', U'\u00FC', U'\u20AC', U'\U0001F9B4',
                                                 0xD800, 0x110000, 7),
                     editing.rules);
    else
      editing.press(
          *rc::gen::element(Key::Left, Key::Right, Key::Home, Key::End, Key::Backspace, Key::Delete,
                            Key::A, Key::C, Key::X, Key::V, Key::Z, Key::Y, Key::Enter),
          modifiers);
    const TextCursor before = editing.edit.cursor;
    keep_cursor_inside(editing.edit, editing.text);
    RC_ASSERT(before.caret == editing.edit.cursor.caret);
    RC_ASSERT(before.anchor == editing.edit.cursor.anchor);
    RC_ASSERT(editing.text.size() <= editing.rules.max_bytes || editing.rules.max_bytes == 0);
    RC_ASSERT(is_utf8(editing.text));
  }
}

}  // namespace
}  // namespace hallux::ui
