#include "ui/render/scene/swarf.h"

#include <gtest/gtest.h>

namespace hallux::tests {
namespace {

using namespace ui;

TEST(Swarf, IsTheSameForTheSameSeedAndEnds) {
  Swarf first(4), second(4);
  const SwarfSource source{{}, 10.0, 12.0, false};
  for (int i = 0; i < 60; ++i) {
    first.advance(1.0 / 60.0, source);
    second.advance(1.0 / 60.0, source);
  }
  ASSERT_GT(first.chips().size(), 50U);
  ASSERT_LE(first.chips().size(), Swarf::chips_at_most);
  ASSERT_EQ(first.chips().size(), second.chips().size());
  for (std::size_t i = 0; i < first.chips().size(); ++i) {
    EXPECT_EQ(first.chips()[i].place_mm, second.chips()[i].place_mm);
  }
  for (int i = 0; i < 20; ++i) first.advance(0.1, {});
  EXPECT_TRUE(first.chips().empty());
}

}  // namespace
}  // namespace hallux::tests
