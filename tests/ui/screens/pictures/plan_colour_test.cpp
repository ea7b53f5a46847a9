// The plan has one colour everywhere: in three dimensions, in sections and charts, in the report.
// One for each ground, visible as a graphic (WCAG 2.1, 1.4.11) on all that lies beside it.
#include <gtest/gtest.h>

#include <cstdio>
#include <span>
#include <string>

#include "simulator/base/embedded.h"
#include "ui/render/scene/palette.h"
#include "ui/widgets/look/theme.h"

namespace hallux::ui {

/// Made by the build from report.css.
std::span<const EmbeddedText> report_styles() noexcept;

namespace {

constexpr double visible = 3.0;

std::string styles() {
  std::string text;
  for (const EmbeddedText& file : report_styles()) text += file.text;
  return text;
}

/// Of that name, on paper or on a dark screen, which comes second.
Color report_colour(const std::string& name, bool is_dark) {
  const std::string text = styles(), key = "--" + name + ": #";
  std::size_t at = text.find(key);
  if (is_dark) at = text.find(key, at + 1);
  EXPECT_NE(at, std::string::npos) << name;
  return rgb(static_cast<std::uint32_t>(std::stoul(text.substr(at + key.size(), 6), nullptr, 16)));
}

Color color_of(const Float3& part) {
  const auto byte = [](float share) { return static_cast<std::uint8_t>(share * 255.0F + 0.5F); };
  return {byte(part.x), byte(part.y), byte(part.z)};
}

std::string hex(const Color& color) {
  char text[8];
  static_cast<void>(
      std::snprintf(text, sizeof text, "%02X%02X%02X", color.red, color.green, color.blue));
  return text;
}

class PlanColour : public testing::TestWithParam<bool> {
 protected:
  const Theme theme_ = make_theme(GetParam() ? ThemeName::Dark : ThemeName::Light);
  const Palette palette_ = palette_of(GetParam() ? Ground::Dark : Ground::Light);
};

TEST_P(PlanColour, IsOneEverywhere) {
  EXPECT_EQ(hex(theme_.reference), hex(color_of(palette_.reference)));
  EXPECT_EQ(hex(theme_.reference), hex(report_colour("plan", GetParam())));
  EXPECT_NE(styles().find(".plan { fill: none; stroke: var(--plan);"), std::string::npos);
}

TEST_P(PlanColour, IsSeenOnEveryGround) {
  for (const Color& ground :
       {theme_.card, theme_.page, color_of(palette_.ground_middle), color_of(palette_.ground_rim),
        report_colour("card", GetParam()), report_colour("bone", GetParam())})
    EXPECT_GE(contrast(theme_.reference, ground), visible) << hex(ground);
}

INSTANTIATE_TEST_SUITE_P(Both, PlanColour, testing::Bool(), [](const auto& tested) {
  return std::string(tested.param ? "Dark" : "Light");
});

}  // namespace
}  // namespace hallux::ui
