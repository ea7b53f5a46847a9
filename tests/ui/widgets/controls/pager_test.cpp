#include "ui/widgets/controls/pager.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// Five of twelve things.
struct Turned {
  explicit Turned(float scale = 1.0F)
      : driver(texts,
               [this](Ui& ui) {
                 const std::string words = "Things from " + std::to_string(first + 1);
                 first = pager(ui, "things", {20.0F, 20.0F, 400.0F, pager_height},
                               {first, 5, 12, words, "Earlier things", "Later things"});
               },
               {1280.0F, 720.0F, scale}) {}

  const Texts texts = english_texts();
  int first = 0;
  Driver driver;
};

TEST(Pager, EndsWithAFullPageAndComesBack) {
  Turned turned;
  EXPECT_TRUE(turned.driver.sees("Things from 1"));
  EXPECT_FALSE(turned.driver.widget("things.back").is_enabled);
  turned.driver.click("things.on");
  EXPECT_EQ(turned.first, 5);
  turned.driver.click("things.on");
  EXPECT_TRUE(turned.driver.sees("Things from 8"));
  EXPECT_FALSE(turned.driver.widget("things.on").is_enabled);
  turned.driver.click("things.back");
  turned.driver.click("things.back");
  EXPECT_TRUE(turned.driver.sees("Things from 1"));
}

TEST(Pager, AtAnEndTheFocusStaysAndIsToldWhy) {
  Turned turned;
  const std::string at_first(turned.texts.text("pager.at_first"));
  const std::string at_last(turned.texts.text("pager.at_last"));
  turned.driver.press(Key::Tab);
  ASSERT_EQ(turned.driver.focused(), "things.back");
  EXPECT_TRUE(turned.driver.sees(at_first));
  turned.driver.press(Key::Tab);
  ASSERT_EQ(turned.driver.focused(), "things.on");
  turned.driver.press(Key::Space);
  turned.driver.press(Key::Enter);
  EXPECT_EQ(turned.first, 7);
  EXPECT_EQ(turned.driver.focused(), "things.on");
  EXPECT_TRUE(turned.driver.sees(at_last));
  turned.driver.press(Key::Space);
  EXPECT_EQ(turned.first, 7) << "it leads nowhere";
}

TEST(Pager, CutsNothingOffAtAnyScale) {
  for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) {
    Turned turned(scale);
    EXPECT_THAT(turned.driver.faults(), IsEmpty()) << scale;
  }
}

}  // namespace
}  // namespace hallux::ui
