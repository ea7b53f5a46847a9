#include <gtest/gtest.h>

#include <cmath>

#include "tests/ui/screens/operating/drawn_operation.h"

namespace hallux::ui {
namespace {

/// How far the pixel is from the colour, the sum of its three parts.
int distance(const Pixels& picture, int x, int y, const Color& colour) {
  const std::size_t at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.size.width) +
           static_cast<std::size_t>(x));
  return std::abs(picture.rgba[at] - colour.red) + std::abs(picture.rgba[at + 1] - colour.green) +
         std::abs(picture.rgba[at + 2] - colour.blue);
}

TEST(OperatingPicture, SideBySideEachEyeSeesThePointerInItsHalf) {
  DrawnOperation operation("silver");
  operation.press(Key::Enter);
  ASSERT_TRUE(operation.until([&] { return operation.person().driver().has("operate.pause"); }));
  operation.press(Key::P);
  operation.press(Key::F9);
  const Color ink = operation.person().driver().ui().theme().text;
  // Nothing lies there: neither bone nor saw nor panel.
  constexpr int x = 1100, y = 440, half = 640;
  // A little below the tip, squeezed to half the width.
  constexpr int in_left = x / 2 + 2, below = y + 9;
  operation.move_to({x, y});
  const Pixels with = operation.picture();
  EXPECT_LT(distance(with, in_left, below, ink), 30);
  EXPECT_LT(distance(with, half + in_left, below, ink), 30);
  EXPECT_GT(distance(with, x + 4, below, ink), 200) << "not where the desktop would show it";
  operation.move_to({x, 540.0F});
  const Pixels without = operation.picture();
  EXPECT_GT(distance(without, in_left, below, ink), 200);
  EXPECT_GT(distance(without, half + in_left, below, ink), 200);
}

// As long as nobody moves the saw; and the first move ends it.
TEST(OperatingPicture, IsRefinedWhileTheHandRestsAndMovesOnAtOnce) {
  DrawnOperation operation("silver");
  operation.press(Key::Enter);
  ASSERT_TRUE(operation.until([&] { return operation.person().driver().has("operate.pause"); }));
  ASSERT_TRUE(operation.until([&] { return !operation.scenes().is_unfinished(); }));
  operation.press(Key::PageUp);
  EXPECT_TRUE(operation.scenes().is_unfinished());
}

// What rests and is refined asks for no frame: an idle window takes no processor.
TEST(OperatingPicture, OfAPausedOperationIsRefinedAndThenDrawnNoMore) {
  DrawnOperation operation("silver");
  operation.press(Key::Enter);
  ASSERT_TRUE(operation.until([&] { return operation.person().driver().has("operate.pause"); }));
  operation.press(Key::P);
  EXPECT_EQ(operation.person().driver().ui().next_frame_in_s(), 0.0) << "there is more to draw";
  ASSERT_TRUE(operation.until([&] { return !operation.scenes().is_unfinished(); }));
  ASSERT_TRUE(
      operation.until([&] { return operation.person().driver().ui().next_frame_in_s() > 1.0; }));
}

}  // namespace
}  // namespace hallux::ui
