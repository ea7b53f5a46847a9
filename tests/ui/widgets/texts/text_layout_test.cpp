#include "ui/widgets/texts/text_layout.h"

#include <gtest/gtest.h>
#include <imgui.h>
#include <rapidcheck/gtest.h>

#include <cmath>

namespace hallux::ui {
namespace {

/// The fonts at one scale, without a user interface around them.
class Fonts {
 public:
  explicit Fonts(float scale)
      : context_(ImGui::CreateContext()), atlas_(*ImGui::GetIO().Fonts, find_fonts(), scale) {}
  Fonts(const Fonts&) = delete;
  Fonts& operator=(const Fonts&) = delete;
  ~Fonts() { ImGui::DestroyContext(context_); }
  const FontFace& face(Type type) const { return atlas_.face(type); }
  static int picture_width() { return ImGui::GetIO().Fonts->TexWidth; }
  static int picture_height() { return ImGui::GetIO().Fonts->TexHeight; }

 private:
  ImGuiContext* context_;
  FontAtlas atlas_;
};

class FontScale : public testing::TestWithParam<float> {};

TEST_P(FontScale, DigitsAreTabularInEveryType) {
  const Fonts fonts(GetParam());
  for (int type = 0; type < type_count; ++type) {
    const FontFace& face = fonts.face(static_cast<Type>(type));
    const float width = text_width(face, "0");
    for (const char* digit : {"1", "2", "3", "4", "5", "6", "7", "8", "9"})
      EXPECT_EQ(text_width(face, digit), width) << type;
    EXPECT_EQ(width, std::round(width));
  }
}

// Where a digit leaned over the space before it, "trainee 4" read like one word.
TEST_P(FontScale, NoDigitBeginsBeforeItsPlace) {
  const Fonts fonts(GetParam());
  for (int type = 0; type < type_count; ++type)
    for (char32_t digit = U'0'; digit <= U'9'; ++digit)
      EXPECT_GE(fonts.face(static_cast<Type>(type)).glyph(digit).left, 0.0F)
          << type << " " << static_cast<char>(digit);
}

TEST_P(FontScale, TheTypeScaleGrowsInProportion) {
  const Fonts fonts(GetParam());
  const float word = text_width(fonts.face(Type::Body), "Medial eminence resection");
  const Fonts whole(1.0F);
  const float at_one = text_width(whole.face(Type::Body), "Medial eminence resection");
  // A face has whole pixels only: 17 px at 80 % become 14 instead of 13.6.
  EXPECT_NEAR(word / at_one, GetParam(), 0.035F * GetParam());
}

TEST_P(FontScale, ThePictureFitsTheSmallestCommonTexture) {
  const Fonts fonts(GetParam());
  EXPECT_LE(Fonts::picture_width(), 4096);
  EXPECT_LE(Fonts::picture_height(), 4096);
}

TEST_P(FontScale, LettersOfTheCatalogueAndOfNamesAreThere) {
  const Fonts fonts(GetParam());
  for (const char32_t letter : {U'A', U'\u00DF', U'\u0142', U'\u0416', U'\u03B1', U'\u2212',
                                U'\u2013', U'\u2026', U'\u2264', U'\u2009'})
    EXPECT_TRUE(fonts.face(Type::Body).has(letter)) << static_cast<unsigned>(letter);
  EXPECT_TRUE(fonts.face(Type::Score).has(U'\u2212'));
}

INSTANTIATE_TEST_SUITE_P(Scales, FontScale, testing::Values(0.8F, 1.0F, 1.5F, 2.0F));

TEST(TextLayout, ReadsUtf8AndMarksWhatIsBroken) {
  std::size_t place = 0;
  EXPECT_EQ(next_code_point("\xE2\x82\xACx", place), U'\u20AC');
  EXPECT_EQ(place, 3U);
  place = 0;
  EXPECT_EQ(next_code_point("\xE2\x82", place), char32_t{0xFFFD});
  EXPECT_EQ(place, 1U);
}

TEST(TextLayout, ShortensWithAnEllipsisThatFits) {
  const Fonts fonts(1.0F);
  const FontFace& face = fonts.face(Type::Body);
  EXPECT_EQ(shortened(face, "Chevron", 500.0F), "Chevron");
  const std::string cut = shortened(face, "I could not see the first cut from this side.", 120.0F);
  EXPECT_LE(text_width(face, cut), 120.0F);
  EXPECT_TRUE(cut.ends_with("\xE2\x80\xA6"));
  EXPECT_GT(text_width(face, cut), 90.0F);
}

TEST(TextLayout, BreaksAtSpacesAndNewLines) {
  const Fonts fonts(1.0F);
  const FontFace& face = fonts.face(Type::Body);
  const std::string text = "one two\nthree";
  const std::vector<TextLine> lines = broken_lines(face, text, 400.0F);
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(text.substr(lines[0].begin, lines[0].end - lines[0].begin), "one two");
  EXPECT_EQ(text.substr(lines[1].begin, lines[1].end - lines[1].begin), "three");
  EXPECT_EQ(broken_lines(face, "", 100.0F).size(), 1U);
}

RC_GTEST_PROP(TextLayout, NoLineIsWiderThanItsRoomAndNoLetterIsLost, ()) {
  static const Fonts fonts(1.0F);
  const FontFace& face = fonts.face(Type::Small);
  const auto letters = *rc::gen::container<std::string>(rc::gen::element('a', 'W', 'i', ' ', '\n'));
  const float width = static_cast<float>(*rc::gen::inRange(20, 300));
  std::string kept, wanted;
  for (const TextLine& line : broken_lines(face, letters, width)) {
    const std::string part = letters.substr(line.begin, line.end - line.begin);
    RC_ASSERT(text_width(face, part) <= width + 0.01F);
    for (const char letter : part)
      if (letter != ' ') kept += letter;
  }
  for (const char letter : letters)
    if (letter != ' ' && letter != '\n') wanted += letter;
  RC_ASSERT(kept == wanted);
}

}  // namespace
}  // namespace hallux::ui
