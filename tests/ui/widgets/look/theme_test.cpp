#include "ui/widgets/look/theme.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

namespace hallux::ui {
namespace {

constexpr double readable = 4.5, visible = 3.0;

using NamedColor = std::pair<std::string, Color>;

std::vector<NamedColor> grounds_of(const Theme& theme) {
  return {{"page", theme.page},   {"side", theme.side},
          {"card", theme.card},   {"raise", theme.raise},
          {"chip", theme.chip},   {"accent_soft", theme.accent_soft},
          {"popup", theme.popup}, {"popup_raise", theme.popup_raise},
          {"badge", theme.badge}};
}

class ThemeContrast : public testing::TestWithParam<ThemeName> {
 protected:
  const Theme theme_ = make_theme(GetParam());

  static void expect_at_least(double least, const NamedColor& ink, const NamedColor& ground) {
    EXPECT_GE(contrast(ink.second, ground.second), least) << ink.first << " on " << ground.first;
  }
};

TEST_P(ThemeContrast, TextsCanBeReadOnEveryGround) {
  for (const NamedColor& ground : grounds_of(theme_)) {
    expect_at_least(readable, {"text", theme_.text}, ground);
    expect_at_least(readable, {"text_secondary", theme_.text_secondary}, ground);
  }
  for (const NamedColor& ground : {NamedColor{"page", theme_.page},
                                   {"card", theme_.card},
                                   {"side", theme_.side},
                                   {"raise", theme_.raise},
                                   {"accent_soft", theme_.accent_soft},
                                   {"chip", theme_.chip},
                                   {"popup", theme_.popup},
                                   {"field", theme_.field}})
    expect_at_least(readable, {"text_caption", theme_.text_caption}, ground);
}

TEST_P(ThemeContrast, AccentAndItsTextCanBeRead) {
  expect_at_least(readable, {"on_accent", theme_.on_accent}, {"accent", theme_.accent});
  for (const NamedColor& ground : {NamedColor{"page", theme_.page},
                                   {"card", theme_.card},
                                   {"raise", theme_.raise},
                                   {"accent_soft", theme_.accent_soft},
                                   {"popup", theme_.popup}})
    expect_at_least(readable, {"accent", theme_.accent}, ground);
  expect_at_least(readable, {"bad_text on its button", theme_.bad_text}, {"danger", theme_.danger});
  for (const Color& hue : theme_.avatars)
    expect_at_least(readable, {"initials", theme_.on_avatar}, {"avatar", hue});
}

TEST_P(ThemeContrast, WordsWithAMeaningCanBeReadOnTheirTint) {
  for (const Meaning meaning :
       {Meaning::Good, Meaning::Warn, Meaning::Bad, Meaning::Info, Meaning::Neutral})
    for (const Color ground : {theme_.page, theme_.card})
      EXPECT_GE(contrast(text_of(theme_, meaning), composed(tint_of(theme_, meaning), ground)),
                readable)
          << static_cast<int>(meaning);
}

TEST_P(ThemeContrast, ShapesAndBordersCanBeSeen) {
  for (const Meaning meaning :
       {Meaning::Good, Meaning::Warn, Meaning::Bad, Meaning::Info, Meaning::Neutral})
    EXPECT_GE(contrast(fill_of(theme_, meaning), theme_.card), visible)
        << static_cast<int>(meaning);
  for (const NamedColor& ink : {NamedColor{"border", theme_.border},
                                {"focus", theme_.focus},
                                {"toggle_off", theme_.toggle_off},
                                {"accent", theme_.accent},
                                {"reference", theme_.reference}})
    expect_at_least(visible, ink, {"card", theme_.card});
  expect_at_least(visible, {"focus", theme_.focus}, {"page", theme_.page});
}

TEST_P(ThemeContrast, WordsOnAPanelOverThePictureCanBeRead) {
  // The brightest and the darkest thing that may lie below it.
  for (const Color below : {rgb(0xF2E6D0), rgb(0x0D1318)})
    if (theme_.is_dark() == (luminance(below) > 0.5)) {
      const Color ground = composed(theme_.hud, below);
      EXPECT_GE(contrast(theme_.text, ground), readable);
      EXPECT_GE(contrast(theme_.text_secondary, ground), readable);
    }
}

INSTANTIATE_TEST_SUITE_P(Both, ThemeContrast, testing::Values(ThemeName::Light, ThemeName::Dark),
                         [](const auto& tested) {
                           return tested.param == ThemeName::Dark ? "Dark" : "Light";
                         });

TEST(Color, ContrastOfBlackAndWhiteIsTwentyOne) {
  EXPECT_NEAR(contrast(rgb(0x000000), rgb(0xFFFFFF)), 21.0, 1e-9);
  EXPECT_NEAR(contrast(rgb(0x123456), rgb(0x123456)), 1.0, 1e-12);
  EXPECT_EQ(contrast(rgb(0x10161B), rgb(0xE9EFF3)), contrast(rgb(0xE9EFF3), rgb(0x10161B)));
}

TEST(Color, ComposingHalfAlphaMeetsInTheMiddle) {
  EXPECT_EQ(composed(rgb(0xFFFFFF, 255), rgb(0x000000)), rgb(0xFFFFFF));
  EXPECT_EQ(composed(rgb(0xFFFFFF, 0), rgb(0x204060)), rgb(0x204060));
  EXPECT_NEAR(composed(rgb(0xFFFFFF, 128), rgb(0x000000)).red, 128, 1);
}

}  // namespace
}  // namespace hallux::ui
