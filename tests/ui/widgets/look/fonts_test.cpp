// Letters that the product does not write itself: drawn when a text asks for them, from the first
// font that has them; what none has is a box with its code and never a question mark.
#include "ui/widgets/look/fonts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <set>
#include <tuple>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/marks.h"
#include "ui/widgets/look/code_box.h"
#include "ui/widgets/texts/text_layout.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

class Atlas {
 public:
  explicit Atlas(FontFiles files, float scale = 1.0F)
      : context_(ImGui::CreateContext()), atlas_(*ImGui::GetIO().Fonts, std::move(files), scale) {}
  Atlas(const Atlas&) = delete;
  Atlas& operator=(const Atlas&) = delete;
  ~Atlas() { ImGui::DestroyContext(context_); }

  const FontFace& face(Type type = Type::Body) const { return atlas_.face(type); }
  bool load() { return atlas_.load_wanted(); }
  bool wants() const { return atlas_.wants_letters(); }
  /// After as many frames as it takes.
  const Glyph& loaded(char32_t letter, Type type = Type::Body) {
    face(type).glyph(letter);
    load();
    return face(type).glyph(letter);
  }
  /// How much ink the picture of the glyph has, 0 to 255 for each pixel.
  static long ink_of(const Glyph& glyph) {
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
    const auto at = [](float share, int whole) {
      return static_cast<int>(share * static_cast<float>(whole) + 0.5F);
    };
    long ink = 0;
    for (int y = at(glyph.v0, height); y < at(glyph.v1, height); ++y)
      for (int x = at(glyph.u0, width); x < at(glyph.u1, width); ++x) ink += pixels[y * width + x];
    return ink;
  }

 private:
  ImGuiContext* context_;
  FontAtlas atlas_;
};

FontFiles without_others() {
  FontFiles files = find_fonts();
  files.others.clear();
  return files;
}

TEST(Letters, OfLatinGreekAndCyrillicAreInkInEveryType) {
  Atlas atlas(without_others());
  // Vietnamese, Romanian, Greek with accents, Ukrainian, and one that is there from the start.
  for (const char32_t letter : {U'\u1EC5', U'\u0219', U'\u038C', U'\u03CE', U'\u0491', U'g'}) {
    for (int type = 0; type < type_count; ++type) {
      const Glyph& glyph = atlas.loaded(letter, static_cast<Type>(type));
      EXPECT_TRUE(glyph.is_visible && !glyph.is_box)
          << static_cast<unsigned>(letter) << " " << type;
      EXPECT_GT(Atlas::ink_of(glyph), 500) << static_cast<unsigned>(letter) << " " << type;
    }
  }
}

TEST(Letters, OfOtherScriptsComeFromAnotherInstalledFont) {
  Atlas atlas(find_fonts());
  for (const char32_t letter : {U'\u05E9', U'\u0639', U'\u0531'}) {  // Hebrew, Arabic, Armenian
    const Glyph& glyph = atlas.loaded(letter);
    EXPECT_FALSE(glyph.is_box) << static_cast<unsigned>(letter);
    EXPECT_GT(Atlas::ink_of(glyph), 500);
    EXPECT_GT(glyph.advance, 4.0F);
    EXPECT_LT(glyph.advance, 20.0F) << "as large as the letters beside it";
  }
}

TEST(Letters, ThatNoFontHasAreABoxWithTheirCode) {
  Atlas atlas(without_others());
  for (const char32_t letter : {U'\u05E9', U'\U0001F600', U'\u0E01'}) {
    const Glyph& glyph = atlas.loaded(letter);
    EXPECT_TRUE(glyph.is_box);
    EXPECT_EQ(glyph.advance, code_box_advance(atlas.face().size(), letter));
  }
  EXPECT_FALSE(atlas.wants()) << "asked for once";
}

TEST(Letters, AreAnEmptyPlaceOnlyUntilTheNextFrame) {
  Atlas atlas(find_fonts());
  const Glyph first = atlas.face().glyph(U'\u0416' + 0x60);  // beyond what is there from the start
  EXPECT_FALSE(first.is_visible);
  EXPECT_GT(first.advance, 0.0F);
  EXPECT_TRUE(atlas.wants());
  EXPECT_TRUE(atlas.load());
  EXPECT_FALSE(atlas.load()) << "nothing new";
  EXPECT_TRUE(atlas.face().glyph(U'\u0416' + 0x60).is_visible);
}

TEST(Letters, StayWithinTheirPartOfTheAtlasHoweverManyAreAskedFor) {
  Atlas atlas(find_fonts());
  const int width = ImGui::GetIO().Fonts->TexWidth, height = ImGui::GetIO().Fonts->TexHeight;
  std::set<std::tuple<float, float>> places;
  std::vector<Glyph> last;
  // Every letter of some large scripts in the largest type, a page of them in each frame.
  for (char32_t first = 0x180; first < 0x1A00; first += 100) {
    last.clear();
    for (char32_t letter = first; letter < first + 100; ++letter)
      last.push_back(atlas.loaded(letter, Type::Score));
  }
  EXPECT_EQ(ImGui::GetIO().Fonts->TexWidth, width);
  EXPECT_EQ(ImGui::GetIO().Fonts->TexHeight, height);
  int drawn = 0;
  for (const Glyph& glyph : last) {
    if (!glyph.is_visible || glyph.is_box) continue;
    ++drawn;
    EXPECT_TRUE(places.insert({glyph.u0, glyph.v0}).second) << "two letters in one place";
  }
  EXPECT_GT(Atlas::ink_of(atlas.loaded(U'\u1EC5', Type::Score)), 500)
      << "the older ones went for the new one";
}

TEST(Letters, NewLinesAndTabsInOneLineAreSpaces) {
  Atlas atlas(find_fonts());
  EXPECT_EQ(text_width(atlas.face(), "a\nb\tc"), text_width(atlas.face(), "a b c"));
  EXPECT_FALSE(atlas.wants());
}

TEST(CodeBox, OfTwoLettersDifferAndHaveAllTheirDigits) {
  const auto pixels_of = [](char32_t letter) {
    std::set<std::pair<int, int>> pixels;
    for (const CodeBoxPart& part : code_box_parts(letter)) {
      EXPECT_GE(part.x, 0);
      EXPECT_LE(part.x + part.width, code_box_width(letter));
      EXPECT_LE(part.y + part.height, code_box_height);
      for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) pixels.insert({x, y});
    }
    return pixels;
  };
  std::set<std::set<std::pair<int, int>>> boxes;
  for (const char32_t letter : {U'\u6F22', U'\u6F23', U'\u226F', U'\U0001F600', U'\U0001F601'})
    boxes.insert(pixels_of(letter));
  EXPECT_EQ(boxes.size(), 5U);
}

TEST(Letters, OfANameAreDrawnWhereverItStands) {
  const Texts texts = english_texts();
  std::string typed = "Žofie Άννα Ґалаґан ש 漢 \U0001F600";
  Driver driver(texts, [&](Ui& ui) {
    ui.canvas().text({20.0F, 40.0F}, {Type::Title, ui.theme().text}, typed);
    avatar(ui, {40.0F, 90.0F}, 16.0F, "Ґ", 1);
    field(ui, "name", {20.0F, 140.0F, 400.0F, 42.0F}, typed, {.label = "Name"});
  });
  EXPECT_THAT(driver.faults(), IsEmpty());
  EXPECT_FALSE(driver.ui().next_frame_in_s() <= 0.0) << "it is settled";
  const int version = driver.ui().fonts_version();
  EXPECT_GT(version, 1);
  driver.click("name");
  driver.press(Key::End);
  driver.type("Ω漢");
  EXPECT_EQ(driver.ui().fonts_version(), version) << "nothing that is there is drawn again";
  driver.type("字");
  EXPECT_GT(driver.ui().fonts_version(), version);
  EXPECT_TRUE(typed.ends_with("Ω漢字"));
}

}  // namespace
}  // namespace hallux::ui
