#include "ui/render/gl/gl_objects.h"

#include <gtest/gtest.h>

#include <array>
#include <memory>
#include <string>

#include "tests/ui/render/graphics.h"
#include "ui/render/gl/graphics_error.h"
#include "ui/render/gl/headless_context.h"
#include "ui/render/gl/shader_program.h"

namespace hallux::tests {
namespace {

using GlObjects = Graphics;

TEST_F(GlObjects, LiveAsLongAsTheirOwners) {
  const ObjectCensus before = count_objects();
  {
    const ui::RenderTarget target({64, 32});
    const ui::ShaderProgram program("ground.vert", "ground.frag");
    const ObjectCensus during = count_objects();
    EXPECT_EQ(during.textures, before.textures + 1);
    EXPECT_EQ(during.framebuffers, before.framebuffers + 1);
    EXPECT_EQ(during.renderbuffers, before.renderbuffers + 1);
    EXPECT_EQ(during.programs_and_shaders, before.programs_and_shaders + 1);
  }
  EXPECT_EQ(count_objects(), before);
}

TEST_F(GlObjects, MoveWithoutCopies) {
  ui::GlTexture first;
  const unsigned name = first.name();
  ui::GlTexture second(std::move(first));
  EXPECT_EQ(second.name(), name);
  EXPECT_EQ(first.name(), 0U);  // NOLINT(bugprone-use-after-move): what is left behind is promised
  ui::ShaderProgram program("ground.vert", "ground.frag");
  const unsigned program_name = program.name();
  const ui::ShaderProgram moved(std::move(program));
  EXPECT_EQ(moved.name(), program_name);
}

constexpr std::array<EmbeddedText, 4> broken{
    {{"whole.vert", "void main() { gl_Position = vec4(0.0); }\n"},
     {"colours.glsl", "vec3 warm() {\n  return vec3(1.0)\n}\n"},
     {"broken.frag",
      "#include \"colours.glsl\"\nout vec4 colour;\nvoid main() { colour = vec4(warm(), 1.0); }\n"},
     {"lost.frag", "#include \"nowhere.glsl\"\nvoid main() {}\n"}}};

TEST_F(GlObjects, ARefusedShaderIsNamedWithItsInclude) {
  const ObjectCensus before = count_objects();
  try {
    const ui::ShaderProgram program(broken, "whole.vert", "broken.frag");
    FAIL() << "the shader lacks a semicolon";
  } catch (const ui::GraphicsError& error) {
    const std::string words = error.what();
    EXPECT_NE(words.find("broken.frag"), std::string::npos) << words;
    EXPECT_NE(words.find("1 is colours.glsl"), std::string::npos) << words;
    EXPECT_NE(words.find("1:3"), std::string::npos)
        << "the driver's place: file 1, line 3: " << words;
  }
  EXPECT_EQ(count_objects(), before);
}

TEST_F(GlObjects, AnIncludeThatIsNotThereIsNamed) {
  try {
    const ui::ShaderProgram program(broken, "whole.vert", "lost.frag");
    FAIL() << "nowhere.glsl is no file";
  } catch (const ui::GraphicsError& error) {
    EXPECT_NE(std::string(error.what()).find("nowhere.glsl"), std::string::npos) << error.what();
  }
}

TEST_F(GlObjects, APictureLargerThanTheDriverCanIsRefused) {
  EXPECT_THROW(ui::RenderTarget({1 << 20, 4}), ui::GraphicsError);
  EXPECT_EQ(take_error(), 0U);
}

TEST_F(GlObjects, APictureOfNoPixelsIsOneOfOne) {
  const ui::RenderTarget target({0, -3});
  EXPECT_EQ(target.size(), (ui::PixelSize{1, 1}));
  EXPECT_EQ(target.read().rgba.size(), 4U);
}

TEST(Headless, ContextsCanFollowOneAnother) {
  for (int i = 0; i < 3; ++i) {
    const ui::HeadlessContext context;
    EXPECT_FALSE(ui::renderer_name().empty());
  }
}

TEST(Headless, AContextOutlivesAnother) {
  const auto first = std::make_unique<ui::HeadlessContext>();
  { const ui::HeadlessContext second; }
  // The first is no longer current, but whole: a third can still be made beside it.
  const ui::HeadlessContext third;
  const ui::RenderTarget target({4, 4});
  EXPECT_EQ(target.read().rgba.size(), 64U);
}

}  // namespace
}  // namespace hallux::tests
