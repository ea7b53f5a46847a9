#include "ui/render/gl/headless_context.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>

#include "ui/render/gl/graphics_error.h"

namespace hallux::tests {
namespace {

/// As on a machine without any driver: the dispatcher is told of none.
[[noreturn]] void ask_without_a_driver() {
  setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null", 1);
  try {
    const ui::HeadlessContext context;
    std::exit(0);
  } catch (const ui::GraphicsError& error) {
    std::cerr << error.what() << '\n';
    std::exit(7);
  }
}

TEST(HeadlessContext, SaysWhatIsMissingAndWhatToInstall) {
  testing::GTEST_FLAG(death_test_style) = "threadsafe";
  EXPECT_EXIT(ask_without_a_driver(), testing::ExitedWithCode(7),
              "OpenGL 3.3.*install libegl-mesa0");
}

}  // namespace
}  // namespace hallux::tests
