// Looking for a file: by mouse, by keyboard, by typing, and by dropping it on the window.
#include "ui/screens/parts/path_dialog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/ui/screens/every_size.h"

namespace hallux::ui {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

/// A page with a field for a file, and the dialog in front of it.
class PageWithAFile : public Screen {
 public:
  explicit PageWithAFile(std::string& path, std::string ending = ".json")
      : path_(path), ending_(std::move(ending)) {}
  GuideSection guide_section() const override { return GuideSection::Overview; }
  void draw(Ui& ui, const Rect& content, Shell& shell) override {
    if (chooser_.is_open()) {
      const PathQuestion asked{ui.text("path.file.title"), ui.text("path.file.act"), ending_};
      if (const auto chosen = chooser_.draw(ui, shell, asked)) path_ = *chosen;
      return;
    }
    Rect rest = inset(content, 40.0F);
    path_field(ui, "page.file", rest, path_, {.label = "File"}, chooser_);
  }

 private:
  std::string& path_;
  std::string ending_;
  PathDialog chooser_;
};

class Choosing : public testing::Test {
 protected:
  Choosing() {
    for (const char* folder : {"akin", "silver"}) fs::create_directories(root() / folder);
    for (const char* file : {"bad.json", "akin/akin_2.json", "akin/note.txt", "silver/one.json"})
      std::ofstream(root() / file) << "{}";
    path_ = (root() / "").string();
  }
  fs::path root() const { return own_.data().parent_path() / "scenarios"; }
  Driver& driver() { return visitor_.driver(); }
  void press(std::string_view id) {
    driver().click(id);
    visitor_.finish_work();
  }
  void type(std::string_view words) {
    driver().type(words);
    visitor_.finish_work();
  }
  void drop(const fs::path& path) {
    InputEvent event;
    event.kind = EventKind::FilesDropped;
    event.text = path.string();
    driver().send({event});
    driver().frame();
    driver().settle();
    visitor_.finish_work();
  }

  const database::TemporaryDirectory own_;
  std::string path_;
  SomeVisitor visitor_{std::make_unique<PageWithAFile>(path_)};
};

TEST_F(Choosing, APressGoesIntoAFolderAndTwoTakeAFile) {
  press("page.file.choose");
  EXPECT_TRUE(driver().has("path.row.bad.json"));
  press("path.row.akin");
  EXPECT_TRUE(driver().has("path.row.akin_2.json"));
  EXPECT_FALSE(driver().has("path.row.note.txt")) << "no scenario";
  EXPECT_THAT(driver().faults(), IsEmpty());
  press("path.row.akin_2.json");
  EXPECT_TRUE(driver().has("path.act")) << "it is chosen, not taken";
  press("path.row.akin_2.json");
  EXPECT_FALSE(driver().has("path.act"));
  EXPECT_EQ(path_, (root() / "akin/akin_2.json").string());
}

TEST_F(Choosing, UpAndHomeLeadOn) {
  press("page.file.choose");
  press("path.row.akin");
  press("path.up");
  EXPECT_TRUE(driver().has("path.row.bad.json"));
  press("path.home");
  EXPECT_FALSE(driver().has("path.row.bad.json"));
  press("path.keep");
  EXPECT_EQ(path_, (root() / "").string()) << "who turns back changed nothing";
}

TEST_F(Choosing, TabCompletesWhatIsTypedAndGoesOnWhereThereIsNothingToComplete) {
  press("page.file.choose");
  type("ak");
  EXPECT_FALSE(driver().has("path.row.bad.json")) << "only what begins as it is typed";
  driver().press(Key::Tab);
  visitor_.finish_work();
  EXPECT_EQ(driver().focused(), "path.path");
  EXPECT_TRUE(driver().has("path.row.akin_2.json"));
  type("a");
  driver().press(Key::Tab);
  visitor_.finish_work();
  driver().press(Key::Enter);
  visitor_.finish_work();
  EXPECT_EQ(path_, (root() / "akin/akin_2.json").string());
  press("page.file.choose");
  driver().press(Key::Tab);
  EXPECT_NE(driver().focused(), "path.path");
}

TEST_F(Choosing, IsDoneByKeyboardAlone) {
  press_by_keyboard(visitor_, "page.file.choose");
  for (int tab = 0; tab < 20 && !driver().focused().starts_with("path.row."); ++tab)
    driver().press(Key::Tab);
  driver().press(Key::End);
  EXPECT_EQ(driver().focused(), "path.row.bad.json");
  driver().press(Key::Enter);
  visitor_.finish_work();
  driver().press(Key::Enter);
  visitor_.finish_work();
  EXPECT_EQ(path_, (root() / "bad.json").string());
}

TEST_F(Choosing, WhatIsHiddenIsSeenOnlyWhereItIsAskedFor) {
  std::ofstream(root() / ".kept.json") << "{}";
  press("page.file.choose");
  EXPECT_FALSE(driver().has("path.row..kept.json"));
  press("path.hidden");
  EXPECT_TRUE(driver().has("path.row..kept.json"));
}

TEST_F(Choosing, AFolderThatCannotBeLookedIntoSaysWhichAndWhy) {
  press("page.file.choose");
  type("nowhere/");
  EXPECT_TRUE(driver().sees("cannot be looked into"));
  EXPECT_TRUE(driver().has("path.path")) << "another can be written";
}

TEST_F(Choosing, WhatIsDroppedFillsTheFieldThatIsShown) {
  drop(root() / "bad.json");
  EXPECT_EQ(path_, (root() / "bad.json").string());
  press("page.file.choose");
  drop(root() / "silver/one.json");
  EXPECT_TRUE(driver().has("path.row.one.json"));
  press("path.act");
  EXPECT_EQ(path_, (root() / "silver/one.json").string());
}

TEST_F(Choosing, WhatIsDroppedWhereNothingTakesItIsSaid) {
  class Plain : public Screen {
    GuideSection guide_section() const override { return GuideSection::Overview; }
    void draw(Ui&, const Rect&, Shell&) override {}
  };
  visitor_.shell().replace_all(std::make_unique<Plain>());
  driver().frame();
  drop(root() / "bad.json");
  EXPECT_TRUE(driver().sees("Nothing on this screen takes a file"));
  EXPECT_TRUE(driver().sees("bad.json"));
}

TEST_F(Choosing, ANewFolderNeedsOnlyAName) {
  SomeVisitor visitor(std::make_unique<PageWithAFile>(path_, ""));
  visitor.driver().click("page.file.choose");
  visitor.finish_work();
  EXPECT_FALSE(visitor.driver().has("path.row.bad.json")) << "folders only";
  EXPECT_FALSE(visitor.driver().widget("path.act").is_enabled);
  visitor.driver().type("of-lee");
  visitor.driver().click("path.act");
  EXPECT_EQ(path_, (root() / "of-lee").string());
}

TEST_F(Choosing, NothingIsCutOffAnywhere) {
  EXPECT_THAT(faults_at_every_size([&] { return std::make_unique<PageWithAFile>(path_); },
                                   [](SomeVisitor& visitor) {
                                     visitor.driver().click("page.file.choose");
                                     visitor.finish_work();
                                   }),
              IsEmpty());
}

TEST(FileSizes, AreSaidInTheUnitThatFits) {
  EXPECT_EQ(file_size_text(640), "640 bytes");
  EXPECT_EQ(file_size_text(12'340), "12.3 kB");
  EXPECT_EQ(file_size_text(4'000'000), "4.0 MB");
}

}  // namespace
}  // namespace hallux::ui
