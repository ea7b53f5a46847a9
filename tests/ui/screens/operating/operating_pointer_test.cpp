// The pointer over an operation: what it leads, where it is seen, where it is caught.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "tests/ui/screens/operating/some_operation.h"

namespace hallux::ui {
namespace {

using database::AttemptKind;

TEST(Operating, ThePointerLeadsTheSawAndAMiddleDragTurnsTheView) {
  OperableCourse course("silver");
  Operator person(course, AttemptKind::Practice);
  person.begin();
  const Vec3 before = person.scenes.saw->world_from_tool.translation_mm;
  person.move_to({600.0F, 500.0F});
  person.move_to({640.0F, 500.0F});
  ASSERT_TRUE(person.until([&] {
    return glm::length(person.scenes.saw->world_from_tool.translation_mm - before) > 1.0;
  })) << "40 pixels at 7 millimetres a millimetre are about 2 mm";
  const Quat seen = person.scenes.camera.world_from_view;
  InputEvent press;
  press.kind = EventKind::ButtonPressed;
  press.button = MouseButton::Middle;
  person.driver().send({press});
  person.make_frames(2);
  person.move_to({700.0F, 520.0F});
  EXPECT_NE(person.scenes.camera.world_from_view, seen);
}

/// Where the pointer is a pointer, and where the saw stands for it: in a window that catches none.
class PointerOfAnOperation : public testing::Test {
 protected:
  PointerOfAnOperation() { person_.shell().preferences().captures_pointer = false; }
  PointerShape shape_at(Point place) {
    person_.move_to(place);
    return person_.driver().ui().pointer_shape();
  }
  Point middle_of(std::string_view id) { return person_.driver().widget(id).visible.centre(); }

  static constexpr Point over_the_bone{700.0F, 450.0F};
  OperableCourse course_{"silver"};
  Operator person_{course_, AttemptKind::Practice};
};

TEST_F(PointerOfAnOperation, TheSawStandsForItOverTheBoneWhileItIsLed) {
  EXPECT_EQ(shape_at(over_the_bone), PointerShape::Arrow) << "not begun";
  person_.begin();
  EXPECT_EQ(shape_at(over_the_bone), PointerShape::Hidden);
  EXPECT_EQ(shape_at(middle_of("operate.panel.force")), PointerShape::Arrow);
  EXPECT_EQ(shape_at(middle_of("operate.panel.tool")), PointerShape::Arrow);
  EXPECT_EQ(shape_at(middle_of("operate.pause")), PointerShape::Hand);
  person_.press(Key::P);
  EXPECT_EQ(shape_at(over_the_bone), PointerShape::Arrow) << "paused";
  person_.press(Key::P);
  EXPECT_EQ(shape_at(over_the_bone), PointerShape::Hidden);
  person_.press(Key::End);
  EXPECT_EQ(shape_at({300.0F, 300.0F}), PointerShape::Arrow) << "a question lies over it";
}

TEST_F(PointerOfAnOperation, CaughtItIsFreeWhileTheHandIsLiftedAndInAPause) {
  person_.begin();
  person_.press(Key::C);
  person_.make_frames(3);
  const auto is_caught = [&] { return !person_.driver().ui().captured_by().empty(); };
  EXPECT_TRUE(is_caught());
  for (const Key key : {Key::L, Key::P}) {
    person_.press(key);
    person_.make_frames(3);
    EXPECT_FALSE(is_caught());
    EXPECT_EQ(shape_at(middle_of("operate.pause")), PointerShape::Hand);
    person_.press(key);
    person_.make_frames(3);
    EXPECT_TRUE(is_caught());
  }
}

TEST_F(PointerOfAnOperation, ARightClickLiftsTheHandAndAnotherSetsItDown) {
  person_.begin();
  person_.press(Key::C);
  person_.make_frames(3);
  const auto click_right = [&] {
    person_.driver().send(click_events(over_the_bone, MouseButton::Right));
    person_.make_frames(4);
  };
  click_right();
  EXPECT_TRUE(person_.driver().sees("The hand is lifted"));
  shape_at(over_the_bone);
  click_right();
  EXPECT_FALSE(person_.driver().sees("The hand is lifted"));
}

TEST_F(PointerOfAnOperation, OverAPanelItDoesNotLeadTheSaw) {
  person_.begin();
  const Rect panel = person_.driver().widget("operate.panel.force").visible;
  shape_at({panel.x + 10.0F, panel.mid_y()});
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  person_.until([&] { return std::chrono::steady_clock::now() > end; });
  const Vec3 before = person_.scenes.saw->world_from_tool.translation_mm;
  for (float x = panel.x + 20.0F; x < panel.right() - 10.0F; x += 20.0F) {
    shape_at({x, panel.mid_y()});
  }
  const auto later = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  person_.until([&] { return std::chrono::steady_clock::now() > later; });
  EXPECT_LT(glm::length(person_.scenes.saw->world_from_tool.translation_mm - before), 0.05);
}

TEST_F(PointerOfAnOperation, SideBySideThePictureCarriesIt) {
  person_.press(Key::F9);
  EXPECT_EQ(shape_at(over_the_bone), PointerShape::Hidden) << "one eye alone would see it";
  EXPECT_EQ(shape_at(middle_of("operate.begin")), PointerShape::Hidden);
  person_.begin();
  EXPECT_EQ(shape_at(middle_of("operate.pause")), PointerShape::Hidden);
  person_.click("operate.pause");
  EXPECT_TRUE(person_.driver().sees("Paused")) << "its place is the place of the layout";
  person_.press(Key::F9);
  EXPECT_EQ(shape_at(over_the_bone), PointerShape::Arrow) << "an anaglyph is one picture";
}
}  // namespace
}  // namespace hallux::ui
