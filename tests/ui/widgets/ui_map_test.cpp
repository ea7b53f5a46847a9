#include "ui/widgets/ui_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {
namespace {

class UiMapFile : public testing::Test {
 protected:
  Texts texts_ = english_texts();
};

TEST_F(UiMapFile, NamesWhatCanBeSeenAndReachedButNeverWhatAFieldHolds) {
  std::string login = "trainee-12", password = "geheim";
  bool is_asking = false;
  Driver driver(texts_,
                [&](Ui& ui) {
                  field(ui, "form.login", {20, 60, 300, 42}, login, {"Login"});
                  FieldSpec secret{"Password"};
                  secret.is_secret = true;
                  field(ui, "form.password", {20, 150, 300, 42}, password, secret);
                  ButtonSpec off{"Sign in"};
                  off.why_off = "Type your password first.";
                  ui.tell("form.hint", "Ask for a code", {20, 300, 100, 20});
                  button(ui, "form.submit", {20, 220, 300, 44}, off);
                  if (is_asking) question(ui, "ask", {"Sure?", "All of it.", "Erase", "Keep"});
                },
                {1440, 900, 1.5F});
  const std::string text = ui_map_json(driver.content(), 1.5F);
  EXPECT_EQ(text.find("trainee-12"), std::string::npos);
  EXPECT_EQ(text.find("geheim"), std::string::npos);
  const nlohmann::json map = nlohmann::json::parse(text);
  ASSERT_EQ(map["widgets"].size(), 4U);
  EXPECT_EQ(
      map["widgets"][0],
      nlohmann::json::parse(
          R"({"id":"form.login","label":"Login","x":30,"y":90,"w":450,"h":63,"enabled":true})"));
  EXPECT_EQ(map["widgets"][3]["enabled"], false);
  EXPECT_EQ(map["widgets"][3]["reason"], "Type your password first.");
  EXPECT_EQ(map["read_outs"], nlohmann::json::parse(R"([{"id":"form.hint","text":"Ask for a code",
                                                        "x":30,"y":450,"w":150,"h":30}])"));
  EXPECT_EQ(map["captured"], "");
  is_asking = true;
  driver.frame();
  driver.settle();
  const nlohmann::json asked = nlohmann::json::parse(ui_map_json(driver.content(), 1.5F));
  ASSERT_EQ(asked["widgets"].size(), 2U) << "what lies below a question cannot be reached";
  EXPECT_TRUE(asked["read_outs"].empty());
  EXPECT_EQ(asked["widgets"][0]["id"], "ask.keep");
  EXPECT_EQ(map["focus"], "");
  EXPECT_EQ(asked["focus"], "ask.keep") << "the safe answer";
}

FrameContent content_with(const std::string& id) {
  FrameContent content;
  Widget widget;
  widget.id = id, widget.label = "L", widget.rect = widget.visible = {1, 2, 3, 4};
  content.widgets = {widget};
  return content;
}

TEST_F(UiMapFile, IsWrittenAtMostTenTimesASecond) {
  std::string written;
  UiMap map([&](const std::string& json) { written = json; });
  EXPECT_TRUE(std::isinf(map.update(content_with("a"), 1.0F, 10.0)));
  EXPECT_NE(written.find("\"a\""), std::string::npos);
  EXPECT_NEAR(map.update(content_with("b"), 1.0F, 10.04), 0.06, 1e-9);
  EXPECT_EQ(written.find("\"b\""), std::string::npos);
  EXPECT_TRUE(std::isinf(map.update(content_with("b"), 1.0F, 10.11)));
  EXPECT_NE(written.find("\"b\""), std::string::npos);
}

TEST_F(UiMapFile, BeginsAsItsKindOfOutputDoes) {
  EXPECT_EQ(ui_map_json(content_with("a"), 1.0F).rfind("{\n \"focus\": ", 0), 0U);
}

}  // namespace
}  // namespace hallux::ui
