#include "simulator/base/utf8.h"

#include <gtest/gtest.h>

namespace hallux {
namespace {

TEST(Utf8, IsTakenAsTheStandardDefinesIt) {
  EXPECT_TRUE(is_utf8(""));
  EXPECT_TRUE(is_utf8("M\xC3\xBCller \xE2\x82\xAC \xF0\x9F\xA6\xB6"));
  for (const std::string_view broken :
       {"\x80", "\xC3", "\xC0\xAF", "\xE0\x80\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xFF"}) {
    EXPECT_FALSE(is_utf8(broken));
  }
}

TEST(Utf8, LettersThatNobodySeesAreFound) {
  EXPECT_FALSE(has_hidden_letters("Silver, 1923\n\tmedial"));
  EXPECT_FALSE(has_hidden_letters("\xD7\xA2\xD7\xA6\xD7\x9D"));  // Hebrew needs no marks
  EXPECT_TRUE(has_hidden_letters("exe\xE2\x80\xAEslov"));        // U+202E
  EXPECT_TRUE(has_hidden_letters("a\xE2\x81\xA6z"));             // U+2066
  EXPECT_TRUE(has_hidden_letters("a\x1B[2Jz"));
  EXPECT_TRUE(has_hidden_letters("a\xC2\x9Bz"));  // U+009B
}

TEST(Utf8, ACharacterIsWrittenAsItIsRead) {
  for (const std::uint32_t value :
       {0x41U, 0x7FU, 0x80U, 0x7FFU, 0x800U, 0xFFFDU, 0x10000U, 0x10FFFFU}) {
    std::string text;
    append_utf8(text, value);
    EXPECT_EQ(first_character(text).value, value);
    EXPECT_EQ(first_character(text).byte_count, text.size());
  }
  std::string none;
  append_utf8(none, 0xD800U);
  append_utf8(none, 0x110000U);
  EXPECT_EQ(none, "");
}

TEST(Utf8, OfATextFromOutsideWhatIsSeenIsKept) {
  EXPECT_EQ(visible_text("Space\x1B[2JMouse\n\xFF \xE2\x80\xAEM\xC3\xBCller"),
            "Space[2JMouse M\xC3\xBCller");
}

}  // namespace
}  // namespace hallux
