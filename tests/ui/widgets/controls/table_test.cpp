#include "ui/widgets/controls/table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

struct People {
  Texts texts = english_texts();
  TableState state;
  std::vector<int> opened;
  int rows = 20, cells_drawn = 0;
  bool has_checkboxes = true;

  void draw(Ui& ui) {
    const std::array<TableColumn, 2> columns{{{"Name", 0.0F, 1.0F, Align::Left, 0.0F, true},
                                              {"Attempts", 90.0F, 1.0F, Align::Right, 0.0F, true}}};
    TableSpec spec;
    spec.columns = columns;
    spec.row_count = rows;
    spec.has_checkboxes = has_checkboxes;
    spec.label = "People";
    spec.row_id = [](int row) { return std::to_string(row); };
    cells_drawn = 0;
    spec.draw_cell = [this](Ui& on, int row, int column, const Rect& cell) {
      ++cells_drawn;
      on.canvas().text_in(cell,
                          {Type::Body, on.theme().text, column == 1 ? Align::Right : Align::Left},
                          std::to_string(row));
    };
    const TableResponse response = table(ui, "people", {40, 40, 600, 340}, spec, state);
    if (response.opened) opened.push_back(*response.opened);
  }
};

TEST(Table, SpaceChoosesAndShiftWithArrowsExtends) {
  People people;
  Driver driver(people.texts, [&](Ui& ui) { people.draw(ui); });
  driver.click("people.2");
  EXPECT_THAT(people.state.chosen, ElementsAre("2"));
  driver.press(Key::Down);
  EXPECT_EQ(driver.focused(), "people.3");
  driver.press(Key::Space);
  EXPECT_THAT(people.state.chosen, ElementsAre("2", "3"));
  driver.press(Key::Down, {.shift = true});
  driver.press(Key::Down, {.shift = true});
  EXPECT_THAT(people.state.chosen, ElementsAre("3", "4", "5"));
  driver.press(Key::A, {.control = true});
  EXPECT_EQ(people.state.chosen.size(), 20U);
  driver.click("people.all");
  EXPECT_THAT(people.state.chosen, IsEmpty());
}

TEST(Table, EnterAndADoubleClickOpen) {
  People people;
  Driver driver(people.texts, [&](Ui& ui) { people.draw(ui); });
  driver.click("people.1");
  driver.press(Key::Down);
  driver.press(Key::Enter);
  EXPECT_THAT(people.opened, ElementsAre(2));
  driver.double_click("people.4");
  EXPECT_THAT(people.opened, ElementsAre(2, 4));
}

TEST(Table, WithoutCheckboxesAPressOpens) {
  People people;
  people.has_checkboxes = false;
  Driver driver(people.texts, [&](Ui& ui) { people.draw(ui); });
  driver.click("people.3");
  EXPECT_THAT(people.opened, ElementsAre(3));
  EXPECT_THAT(people.state.chosen, IsEmpty());
}

TEST(Table, ANarrowOneLeavesOutColumnsAndKeepsTheirNumbers) {
  const Texts texts = english_texts();
  TableState state;
  float width = 600.0F;
  std::set<int> drawn;
  Driver driver(texts, [&](Ui& ui) {
    const std::array<TableColumn, 3> columns{{{"Name", 0.0F, 1.0F, Align::Left, 0.0F, true},
                                              {"Seen", 90.0F, 1.0F, Align::Left, 500.0F, true},
                                              {"Attempts", 90.0F, 1.0F, Align::Right, 0.0F, true}}};
    TableSpec spec;
    spec.columns = columns;
    spec.row_count = 3;
    spec.label = "People";
    spec.row_id = [](int row) { return std::to_string(row); };
    drawn.clear();
    spec.draw_cell = [&](Ui&, int, int column, const Rect& cell) {
      drawn.insert(column);
      EXPECT_LE(cell.right(), 40.0F + width + 0.5F);
      if (column == 2) {
        EXPECT_NEAR(cell.right(), 40.0F + width, 0.5F) << "no hole is left";
      }
    };
    table(ui, "people", {40.0F, 40.0F, width, 340.0F}, spec, state);
  });
  EXPECT_THAT(drawn, ElementsAre(0, 1, 2));
  driver.click("people.sort.1");
  width = 499.0F;
  driver.frame();
  EXPECT_THAT(drawn, ElementsAre(0, 2));
  EXPECT_FALSE(driver.has("people.sort.1"));
  EXPECT_EQ(state.sort.column, 1) << "what is left out still sorts";
  driver.click("people.sort.2");
  EXPECT_EQ(state.sort.column, 2);
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(Table, AHeadSortsAndTurnsRound) {
  People people;
  Driver driver(people.texts, [&](Ui& ui) { people.draw(ui); });
  driver.click("people.sort.1");
  EXPECT_EQ(people.state.sort.column, 1);
  EXPECT_FALSE(people.state.sort.is_descending);
  driver.click("people.sort.1");
  EXPECT_TRUE(people.state.sort.is_descending);
  driver.click("people.sort.0");
  EXPECT_EQ(people.state.sort.column, 0);
  EXPECT_FALSE(people.state.sort.is_descending);
}

TEST(Table, OnlyWhatIsInSightIsLaidOut) {
  People people;
  people.rows = 100000;
  Driver driver(people.texts, [&](Ui& ui) { people.draw(ui); });
  EXPECT_LE(people.cells_drawn, 2 * 12);
  driver.press(Key::Tab);
  driver.press(Key::Tab);
  driver.press(Key::Tab);
  driver.press(Key::Tab);
  ASSERT_EQ(driver.focused(), "people.0");
  for (int step = 0; step < 50; ++step) driver.press(Key::Down);
  EXPECT_EQ(driver.focused(), "people.50");
  EXPECT_GE(driver.widget("people.50").visible.h, 41.0F) << "the focus stays in sight";
}

TEST(Table, AnEmptyOneHarmsNothing) {
  People people;
  people.rows = 0;
  Driver driver(people.texts, [&](Ui& ui) { people.draw(ui); });
  driver.press(Key::A, {.control = true});
  EXPECT_THAT(people.state.chosen, IsEmpty());
  EXPECT_THAT(driver.faults(), IsEmpty());
}

}  // namespace
}  // namespace hallux::ui
