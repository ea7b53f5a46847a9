// The example of ui/widgets/README.md: a screen written with the components, and its test.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/card.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

struct RenameState {
  std::string name, error;
};

/// Asks for a new name. Returns the name once it was saved.
std::optional<std::string> draw_rename_screen(Ui& ui, RenameState& state) {
  ui.canvas().fill(ui.display(), ui.theme().page);
  const Rect content = card(ui, centred(ui.display(), 420.0F, 220.0F), ui.text("rename.title"));
  FieldSpec name;
  name.label = ui.text("rename.name");
  name.error = state.error;
  field(ui, "rename.name", {content.x, content.y + field_label_height, content.w, field_height},
        state.name, name);
  ui.focus_first("rename.name");
  ButtonSpec save{ui.text("rename.save"), ButtonLook::Primary};
  if (state.name.empty()) save.why_off = ui.text("rename.missing");
  const Rect foot{content.x, content.bottom() - button_height, button_width(ui, save),
                  button_height};
  if (button(ui, "rename.save", foot, save)) return state.name;
  return std::nullopt;
}

class RenameScreen : public testing::TestWithParam<float> {
 protected:
  const Texts texts_{
      "rename.title = Rename\nrename.name = Name\nrename.save = Save name\n"
      "rename.missing = Write a name first\n"};
  RenameState state_;
  std::optional<std::string> saved_;
  Driver driver_{texts_,
                 [this](Ui& ui) {
                   if (auto name = draw_rename_screen(ui, state_)) saved_ = name;
                 },
                 {1280.0F, 720.0F, GetParam()}};
};

TEST_P(RenameScreen, EnterSavesTheName) {
  driver_.press(Key::Enter);
  EXPECT_EQ(saved_, std::nullopt) << "an empty name is not saved";
  driver_.type("Trainee 12");
  driver_.press(Key::Enter);
  EXPECT_EQ(saved_, "Trainee 12");
  EXPECT_THAT(driver_.faults(), IsEmpty());
}

TEST_P(RenameScreen, TheMouseSavesTheName) {
  driver_.click("rename.name");
  driver_.type("Trainee 12");
  driver_.click("rename.save");
  EXPECT_EQ(saved_, "Trainee 12");
}

TEST_P(RenameScreen, SaysWhatIsWrong) {
  state_.error = "No spaces in a name. Example: trainee-12";
  driver_.frame();
  EXPECT_TRUE(driver_.sees("Example: trainee-12"));
  EXPECT_THAT(driver_.faults(), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(AtEveryScale, RenameScreen, testing::Values(0.8F, 1.0F, 1.5F));

}  // namespace
}  // namespace hallux::ui
