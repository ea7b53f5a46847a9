#include "ui/widgets/input/focus.h"

#include <gtest/gtest.h>

namespace hallux::ui {
namespace {

Widget control(std::string id, Rect rect = {0, 0, 10, 10}, std::string group = {}) {
  Widget widget;
  widget.id = std::move(id);
  widget.rect = widget.visible = rect;
  widget.group = std::move(group);
  return widget;
}

FrameContent list_of_three() {
  FrameContent content;
  content.widgets = {control("a"), control("row.0", {0, 20, 100, 10}, "row"),
                     control("row.1", {0, 40, 100, 10}, "row"),
                     control("row.2", {0, 60, 100, 10}, "row"), control("b")};
  return content;
}

TEST(Focus, TabVisitsAGroupOnceAtItsChosenWidget) {
  FrameContent content = list_of_three();
  content.widgets[2].is_chosen = true;
  EXPECT_EQ(next_in_tab_order(content, "", false), "a");
  EXPECT_EQ(next_in_tab_order(content, "a", false), "row.1");
  EXPECT_EQ(next_in_tab_order(content, "row.1", false), "b");
  EXPECT_EQ(next_in_tab_order(content, "row.2", false), "b") << "from anywhere in the group";
  EXPECT_EQ(next_in_tab_order(content, "b", true), "row.1");
  EXPECT_EQ(next_in_tab_order(content, "b", false), "a") << "round";
}

TEST(Focus, WhatIsOffIsVisitedForItsReasonAndNotPressed) {
  FrameContent content;
  content.widgets = {control("a"), control("b"), control("c")};
  content.widgets[1].is_enabled = false;
  EXPECT_EQ(next_in_tab_order(content, "a", false), "c") << "it has nothing to say";
  content.widgets[1].why_off = "Type your login first.";
  EXPECT_EQ(next_in_tab_order(content, "a", false), "b");
  EXPECT_TRUE(can_have_focus(content, content.widgets[1]));
  EXPECT_FALSE(can_be_pressed(content, content.widgets[1]));
  EXPECT_TRUE(can_be_pressed(content, content.widgets[2]));
}

TEST(Focus, LowerLayersAreLeftOut) {
  FrameContent content;
  content.widgets = {control("a"), control("b"), control("c")};
  Widget answer = control("keep");
  answer.layer = Layer::Modal;
  content.widgets.push_back(answer);
  EXPECT_EQ(next_in_tab_order(content, "a", false), "keep");
  EXPECT_EQ(next_in_tab_order(content, "keep", false), "keep");
}

TEST(Focus, ArrowsGoToTheNearestOfTheGroup) {
  const FrameContent content = list_of_three();
  EXPECT_EQ(next_by_arrow(content, "row.0", Key::Down), "row.1");
  EXPECT_EQ(next_by_arrow(content, "row.1", Key::Up), "row.0");
  EXPECT_EQ(next_by_arrow(content, "row.0", Key::Up), "row.0");
  EXPECT_EQ(next_by_arrow(content, "row.0", Key::Right), "row.0");
  EXPECT_EQ(next_by_arrow(content, "row.0", Key::End), "row.2");
  EXPECT_EQ(next_by_arrow(content, "row.2", Key::Home), "row.0");
  EXPECT_EQ(next_by_arrow(content, "a", Key::Down), "a") << "in no group";
}

TEST(Focus, ArrowsCrossAGridAsTheEyeDoes) {
  FrameContent content;
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 3; ++column)
      content.widgets.push_back(
          control("card." + std::to_string(row * 3 + column),
                  {300.0F * static_cast<float>(column), 350.0F * static_cast<float>(row), 275, 332},
                  "card"));
  EXPECT_EQ(next_by_arrow(content, "card.0", Key::Right), "card.1");
  EXPECT_EQ(next_by_arrow(content, "card.1", Key::Down), "card.4");
  EXPECT_EQ(next_by_arrow(content, "card.5", Key::Left), "card.4");
  EXPECT_EQ(next_by_arrow(content, "card.4", Key::Up), "card.1");
}

TEST(Focus, PointsOfAChartAreWalkedInTheirOrder) {
  FrameContent content;
  for (int point = 0; point < 4; ++point) {
    content.widgets.push_back(
        control("point." + std::to_string(point),
                {20.0F * static_cast<float>(point), point == 2 ? 500.0F : 0.0F, 10, 10}, "point"));
    content.widgets.back().is_in_sequence = true;
  }
  EXPECT_EQ(next_by_arrow(content, "point.1", Key::Right), "point.2")
      << "a peak is not jumped over";
  EXPECT_EQ(next_by_arrow(content, "point.3", Key::Left), "point.2");
  EXPECT_EQ(next_by_arrow(content, "point.0", Key::Left), "point.0");
  EXPECT_EQ(next_by_arrow(content, "point.3", Key::Right), "point.3");
  EXPECT_EQ(next_by_arrow(content, "point.1", Key::End), "point.3");
}

TEST(Widgets, TheTopmostReachableOneIsUnderThePointer) {
  FrameContent content;
  content.widgets = {control("row", {0, 0, 100, 40}), control("button", {60, 10, 30, 20})};
  EXPECT_EQ(widget_at(content, {70, 20})->id, "button");
  EXPECT_EQ(widget_at(content, {10, 20})->id, "row");
  EXPECT_EQ(widget_at(content, {10, 60}), nullptr);
  Widget item = control("item", {200, 0, 50, 50});
  item.layer = Layer::Popup;
  content.widgets.push_back(item);
  EXPECT_EQ(widget_at(content, {70, 20}), nullptr) << "a menu lies above the page";
  EXPECT_EQ(widget_at(content, {210, 20})->id, "item");
}

}  // namespace
}  // namespace hallux::ui
