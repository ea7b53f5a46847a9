#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/ui/screens/operating/some_operation.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;

/// Places on the chevron's tray: two blades, six wires, seven drills, then screws.
constexpr const char* first_wire = "operate.tray.2";

class Tray : public testing::Test {
 protected:
  static OperableCourse& course() {
    static OperableCourse chevron("chevron");
    return chevron;
  }
  static bool has_tool(const Operator& person, const std::string& words) {
    const auto& told = person.driver().content().read_outs;
    const auto tool = std::ranges::find(told, "operate.tool", &ReadOut::id);
    return tool != told.end() && tool->text.find(words) != std::string::npos;
  }
};

TEST_F(Tray, IsOpenedByAKeyChosenFromByKeysAndTellsWhatIsHeld) {
  Operator person(course(), AttemptKind::Practice);
  person.begin();
  EXPECT_TRUE(has_tool(person, "Sagittal saw"));
  EXPECT_TRUE(person.scenes.saw.has_value());
  person.press(Key::B);
  ASSERT_TRUE(person.until([&] { return person.driver().has(first_wire); }));
  EXPECT_FALSE(person.driver().has("operate.go_on")) << "the time goes on";
  person.press(Key::Down);
  person.press(Key::Enter);
  ASSERT_TRUE(person.until([&] { return has_tool(person, "Wire driver"); }));
  EXPECT_FALSE(person.driver().has(first_wire));
  ASSERT_TRUE(person.until([&] { return !person.scenes.saw.has_value(); }));
}

TEST_F(Tray, IsClosedByEscapeWithWhatIsHeld) {
  Operator person(course(), AttemptKind::Practice);
  person.begin();
  person.press(Key::B);
  ASSERT_TRUE(person.until([&] { return person.driver().has(first_wire); }));
  person.press(Key::Escape);
  ASSERT_TRUE(person.until([&] { return !person.driver().has(first_wire); }));
  EXPECT_TRUE(has_tool(person, "Sagittal saw"));
  EXPECT_FALSE(person.driver().has("operate.go_on")) << "nothing was paused";
}

TEST_F(Tray, LiesInASmallWindow) {
  constexpr Point size{853.0F, 533.0F};
  Operator person(course(), AttemptKind::Practice, 1.5F, size);
  person.begin();
  person.press(Key::B);
  ASSERT_TRUE(person.until([&] { return person.driver().has(first_wire); }));
  for (const Widget& widget : person.driver().content().widgets) {
    if (!widget.id.starts_with("operate.tray.") || widget.visible.is_empty()) continue;
    EXPECT_GE(widget.rect.x, 0.0F) << widget.id;
    EXPECT_LE(widget.rect.right(), size.x) << widget.id;
  }
}

}  // namespace
}  // namespace hallux::ui
