// Facts of pictures, measured: what is where, in which colours, and what went to the card for it.
#include "ui/render/renderer.h"

#include <epoxy/gl.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>

#include "tests/ui/render/operating_world.h"
#include "ui/render/headless_context.h"
#include "ui/render/picture.h"
#include "ui/render/stereo.h"

namespace hallux::tests {
namespace {

using namespace ui;

constexpr PixelSize size{640, 360};
constexpr double coarse_mm = 0.75;

struct Facts {
  double bone = 0.0, blade = 0.0;     ///< shares of the picture that are warm, or grey and bright
  double bone_x = 0.0, bone_y = 0.0;  ///< middle of what is warm, shares from the upper left
};

Facts facts_of(const Pixels& picture) {
  Facts facts;
  double count = 0.0;
  for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4) {
    const int red = picture.rgba[i], green = picture.rgba[i + 1], blue = picture.rgba[i + 2];
    const std::size_t pixel = i / 4, width = static_cast<std::size_t>(picture.size.width);
    if (red > 90 && red > blue + 20) {
      count += 1.0;
      const std::size_t row = pixel / width;
      facts.bone_x += static_cast<double>(pixel - row * width);
      facts.bone_y += static_cast<double>(row);
    }
    if (red > 80 && std::abs(red - green) < 16 && std::abs(red - blue) < 24) facts.blade += 1.0;
  }
  const double pixels = static_cast<double>(picture.rgba.size()) / 4.0;
  facts.bone = count / pixels;
  facts.blade /= pixels;
  facts.bone_x /= std::max(count, 1.0) * picture.size.width;
  facts.bone_y /= std::max(count, 1.0) * picture.size.height;
  return facts;
}

class RendererTest : public testing::Test {
 protected:
  Pixels drawn(const Scene& scene) {
    const RenderTarget target(size);
    renderer_.draw(scene, world_.camera(), target.target());
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    return target.read();
  }

  HeadlessContext context_;
  OperatingWorld world_{coarse_mm};
  Renderer renderer_{RenderQuality{}};
};

TEST_F(RendererTest, TheBoneIsTheWarmThingInTheMiddle) {
  const Facts facts = facts_of(drawn(world_.scene()));
  EXPECT_GT(facts.bone, 0.08);
  EXPECT_LT(facts.bone, 0.6);
  EXPECT_NEAR(facts.bone_x, 0.45, 0.2);
  EXPECT_NEAR(facts.bone_y, 0.5, 0.2);
  EXPECT_GT(facts.blade, 0.01);
}

TEST_F(RendererTest, AnEmptySceneIsGroundOnly) {
  const Facts facts = facts_of(drawn(Scene{}));
  EXPECT_EQ(facts.bone, 0.0);
  EXPECT_EQ(facts.blade, 0.0);
}

TEST_F(RendererTest, TheSamePictureTwiceIsTheSameToTheLastBit) {
  const Pixels first = drawn(world_.scene());
  EXPECT_EQ(first.rgba, drawn(world_.scene()).rgba);
}

TEST_F(RendererTest, ABoneIsSentOnceAndACutSendsLittle) {
  drawn(world_.scene());
  EXPECT_GT(renderer_.counts().uploaded_bytes, 0u);
  const std::uint64_t whole = renderer_.counts().uploaded_bytes;
  drawn(world_.scene());
  EXPECT_EQ(renderer_.counts().uploaded_bytes, 0u);
  world_.saw_to(-2.0);
  drawn(world_.scene());
  EXPECT_GT(renderer_.counts().uploaded_bytes, 0u);
  EXPECT_LT(renderer_.counts().uploaded_bytes, whole);
}

TEST_F(RendererTest, SawingChangesThePicture) {
  const Pixels before = drawn(world_.scene());
  world_.saw_to(2.0);
  EXPECT_NE(before.rgba, drawn(world_.scene()).rgba);
}

TEST_F(RendererTest, SideBySideHoldsBothEyesAndAnaglyphBothColours) {
  StereoStage stage;
  const RenderTarget window(size);
  const auto in = [&](StereoMode mode) {
    stage.draw(renderer_, world_.scene(), world_.camera(), {.mode = mode, .viewer = {}},
               window.target());
    return window.read();
  };
  const Pixels mono = in(StereoMode::Mono), both = in(StereoMode::SideBySide);
  EXPECT_NEAR(facts_of(both).bone, facts_of(mono).bone, 0.2 * facts_of(mono).bone);
  EXPECT_NE(in(StereoMode::Anaglyph).rgba, mono.rgba);
}

TEST_F(RendererTest, APngIsTheSameBytesForTheSamePicture) {
  const Pixels picture = render_picture(renderer_, world_.scene(), world_.camera(), {320, 180});
  EXPECT_EQ(picture.size.width, 320);
  const std::vector<std::byte> file = encode_png(picture);
  ASSERT_GT(file.size(), 1000u);
  EXPECT_EQ(static_cast<unsigned char>(file[1]), 'P');
  EXPECT_EQ(file, encode_png(picture));
}

TEST_F(RendererTest, AFolderThatIsNotThereIsNamed) {
  const Pixels picture{{2, 2}, std::vector<std::uint8_t>(16, 200)};
  try {
    write_png("no_such_folder/picture.png", picture);
    FAIL() << "nothing was thrown";
  } catch (const PictureError& error) {
    EXPECT_NE(std::string(error.what()).find("no_such_folder"), std::string::npos);
  }
}

}  // namespace
}  // namespace hallux::tests
