#include "ui/render/picture.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

/// Columns from black to white in red, rows alike in green.
Pixels ramp(PixelSize size) {
  Pixels picture{size, {}};
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      picture.rgba.insert(picture.rgba.end(),
                          {static_cast<std::uint8_t>(255 * x / (size.width - 1)),
                           static_cast<std::uint8_t>(255 * y / (size.height - 1)), 7, 255});
  return picture;
}

TEST(PictureFile, IsReadAsItWasWritten) {
  const Pixels picture = ramp({37, 21});
  const std::vector<std::byte> bytes = encode_png(picture);
  EXPECT_EQ(png_size(bytes), picture.size);
  const Pixels read = decode_png(bytes);
  EXPECT_EQ(read.size, picture.size);
  EXPECT_EQ(read.rgba, picture.rgba) << "the first row is the uppermost";
}

TEST(PictureFile, ThatIsNoneIsSaid) {
  std::vector<std::byte> bytes = encode_png(ramp({37, 21}));
  bytes.resize(bytes.size() / 2);
  EXPECT_THROW(decode_png(bytes), PictureError);
  EXPECT_THROW(png_size(std::vector<std::byte>(40)), PictureError);
}

TEST(PictureFile, ShrinksToTheMeanOfWhatEachPixelCovers) {
  const Pixels picture{{4, 2}, {0,   0, 0, 255, 200, 0, 0, 255, 100, 0, 0, 255, 100, 0, 0, 255,
                                100, 0, 0, 255, 100, 0, 0, 255, 20,  0, 0, 255, 20,  0, 0, 255}};
  const Pixels half = shrunk(picture, {2, 1});
  EXPECT_EQ(half.size, (PixelSize{2, 1}));
  EXPECT_EQ(half.rgba, (std::vector<std::uint8_t>{100, 0, 0, 255, 60, 0, 0, 255}));
  // Where a pixel covers parts of others: of one and a third in width.
  const Pixels parts = shrunk(picture, {3, 1});
  EXPECT_EQ(parts.rgba[0], 75) << "(0 + 200/3 + 100 + 100/3) / 2 / (4/3)";
  EXPECT_EQ(shrunk(picture, {8, 1}).size, picture.size) << "it is never made larger";
  // A ramp stays one, with its ends where they were.
  const Pixels ramp_half = shrunk(ramp({200, 100}), {60, 30});
  for (int x = 1; x < 60; ++x)
    EXPECT_NEAR(ramp_half.rgba[4U * static_cast<std::size_t>(x)] -
                    ramp_half.rgba[4U * static_cast<std::size_t>(x - 1)],
                255.0 / 60.0, 1.0);
}

}  // namespace
}  // namespace hallux::ui
