#include "ui/screens/guide/guide_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/ui/screens/every_size.h"
#include "tests/ui/screens/some_visitor.h"
#include "ui/render/scene_painter.h"
#include "ui/widgets/controls/field.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

/// A page with something written and something scrolled, from which the guide is asked for.
class SomePage : public Screen {
 public:
  GuideSection guide_section() const override { return GuideSection::Replay; }
  void enter(Shell&) override { ++entered; }
  void leave(Shell&) override { ++left; }
  void draw(Ui& ui, const Rect& content, Shell&) override {
    field(ui, "page.word", {content.x + 32.0F, 40.0F, 300.0F, field_height}, word, {"Word"});
    const Rect view{content.x + 32.0F, 100.0F, 300.0F, 200.0F};
    scrolled = ui.begin_scroll("page.list", "List", view, 900.0F);
    ui.end_scroll();
  }

  std::string word;
  float scrolled = 0.0F;
  int entered = 0, left = 0;
};

/// Keeps which pictures were shown, and their size in pixels.
class NotedPictures : public NoScenePainter {
 public:
  std::uint64_t show(std::string_view name, std::shared_ptr<const Pixels> pixels) override {
    sizes[std::string(name)] = pixels->size;
    return 1;
  }

  std::map<std::string, PixelSize> sizes;
};

class GuideReading : public testing::Test {
 protected:
  GuideReading() {
    auto page = std::make_unique<SomePage>();
    page_ = page.get();
    visitor_ = std::make_unique<SomeVisitor>(std::move(page));
    shell().on_guide([](GuideSection section) { return std::make_unique<GuideScreen>(section); });
    driver().frame();
  }

  Shell& shell() { return visitor_->shell(); }
  Driver& driver() { return visitor_->driver(); }
  void press(Key key, Modifiers modifiers = {}) {
    driver().press(key, modifiers);
    visitor_->finish_work();
  }
  void open() {
    press(Key::F1);
    press(Key::F1);
  }
  /// The row of the contents that is lit.
  std::string lit() {
    for (const Widget& widget : driver().content().widgets)
      if (widget.group == "guide.list" && widget.is_chosen) return widget.label;
    return {};
  }

  SomePage* page_ = nullptr;
  std::unique_ptr<SomeVisitor> visitor_;
};

TEST_F(GuideReading, F1TwiceOpensTheSectionOfTheScreenAndEscComesBackToAllOfIt) {
  driver().click("page.word");
  driver().type("half a word");
  driver().wheel({200.0F, 200.0F}, -2.0F);
  const float scrolled = page_->scrolled;
  ASSERT_GT(scrolled, 0.0F);
  open();
  EXPECT_TRUE(shell().is_guide_shown());
  EXPECT_EQ(lit(), "Watch it again");
  EXPECT_TRUE(driver().sees("Watch it again"));
  EXPECT_THAT(driver().faults(), IsEmpty());
  press(Key::Escape);
  EXPECT_FALSE(shell().is_guide_shown());
  EXPECT_EQ(page_->word, "half a word");
  EXPECT_EQ(page_->scrolled, scrolled);
  EXPECT_EQ(driver().focused(), "page.word");
  EXPECT_EQ(page_->left, 0) << "it lay below all the while";
}

TEST_F(GuideReading, TheButtonOfTheListOpensItToo) {
  press(Key::F1);
  driver().click("help.guide");
  EXPECT_TRUE(shell().is_guide_shown());
  driver().click("guide.close");
  EXPECT_FALSE(shell().is_guide_shown());
}

TEST_F(GuideReading, WhereNobodyMakesAGuideThereIsNoWayToOne) {
  shell().on_guide({});
  press(Key::F1);
  EXPECT_FALSE(driver().has("help.guide"));
  press(Key::F1);
  EXPECT_FALSE(shell().is_guide_shown());
}

TEST_F(GuideReading, ListsItsOwnKeysUnderF1) {
  open();
  press(Key::F1);
  EXPECT_TRUE(driver().sees("Read on or back"));
  EXPECT_FALSE(driver().has("help.guide")) << "one is there already";
  press(Key::Escape);
  EXPECT_TRUE(shell().is_guide_shown());
}

TEST_F(GuideReading, IsReadByKeysFromEndToEnd) {
  open();
  const auto region = [&] { return driver().widget("guide.text"); };
  const float before = region().room_above;
  ASSERT_GT(before, 0.0F);
  press(Key::PageDown);
  EXPECT_GT(region().room_above, before);
  press(Key::End);
  EXPECT_EQ(region().room_below, 0.0F);
  EXPECT_EQ(lit(), "What is kept of you");
  press(Key::Home);
  EXPECT_EQ(region().room_above, 0.0F);
  press(Key::Down);
  EXPECT_GT(region().room_above, 0.0F);
}

TEST_F(GuideReading, ContentsAndLinksLeadAndTheWayBackIsKept) {
  open();
  driver().click("guide.page.2");
  EXPECT_TRUE(driver().sees("Guide for instructors"));
  // The link to a heading of another guide, by keyboard.
  std::string link;
  for (const Widget& widget : driver().content().widgets)
    if (link.empty() && widget.role == Role::Link && widget.label == "the guide for trainees")
      link = widget.id;
  ASSERT_FALSE(link.empty());
  press_by_keyboard(*visitor_, link);
  EXPECT_EQ(lit(), "Watch it again");
  press(Key::Left, {.alt = true});
  EXPECT_TRUE(driver().sees("Guide for instructors"));
  driver().click("guide.earlier");
  EXPECT_EQ(lit(), "Watch it again");
  EXPECT_FALSE(driver().has("guide.earlier")) << "that was the first";
}

TEST_F(GuideReading, EveryLinkOfEveryPageIsReachedByTab) {
  open();
  for (std::size_t page = 0; page < 4; ++page) {
    driver().click("guide.page." + std::to_string(page));
    std::set<std::string> links, reached;
    for (const Widget& widget : driver().content().widgets)
      if (widget.id.starts_with("guide.link.") && widget.is_focusable) links.insert(widget.id);
    for (int tab = 0; tab < 60; ++tab) {
      press(Key::Tab);
      if (driver().focused().starts_with("guide.link.")) {
        reached.insert(driver().focused());
        EXPECT_FALSE(driver().widget(driver().focused()).visible.is_empty());
      }
    }
    EXPECT_EQ(links, reached) << page;
  }
}

TEST_F(GuideReading, CtrlFSearchesAndEnterGoesToTheFirst) {
  open();
  press(Key::F, {.control = true});
  EXPECT_EQ(driver().focused(), "guide.search");
  driver().type("rtprio");
  visitor_->finish_work();
  EXPECT_TRUE(driver().sees("Found in 1 place"));
  press(Key::Enter);
  EXPECT_TRUE(driver().sees("lines with"));
  EXPECT_TRUE(driver().sees("The machine"));
  press(Key::Escape);
  EXPECT_TRUE(shell().is_guide_shown()) << "the search goes first";
  EXPECT_EQ(lit(), "The machine");
  press(Key::Escape);
  EXPECT_FALSE(shell().is_guide_shown());
}

TEST_F(GuideReading, ANarrowWindowShowsTheContentsInPlaceOfThePage) {
  driver().resize(800.0F, 600.0F);
  open();
  EXPECT_FALSE(driver().has("guide.page.0"));
  driver().click("guide.contents");
  EXPECT_TRUE(driver().has("guide.page.0"));
  EXPECT_FALSE(driver().has("guide.text"));
  driver().click("guide.page.3");
  EXPECT_TRUE(driver().sees("Guide for administrators"));
  EXPECT_FALSE(driver().has("guide.page.0"));
}

TEST_F(GuideReading, SomebodyElseBeginsWithoutIt) {
  open();
  shell().set_visitor(std::nullopt);
  driver().frame();
  EXPECT_FALSE(shell().is_guide_shown());
}

TEST(Guide, EveryPictureIsSeenAtItsSizeOnTheScreen) {
  NotedPictures painter;
  SomeVisitor visitor(std::make_unique<GuideScreen>(GuideSection::Overview), 1.5F, &painter);
  visitor.driver().resize(2400.0F, 1500.0F);
  std::size_t pictures = 0;
  const Guides guides;
  for (std::size_t page = 0; page < guides.pages().size(); ++page) {
    for (const MarkdownBlock& block : guides.pages()[page].blocks)
      pictures += block.kind == MarkdownKind::Picture ? 1 : 0;
    visitor.driver().click("guide.page." + std::to_string(page));
    visitor.finish_work();
    for (int down = 0; down < 40; ++down) {
      visitor.driver().press(Key::PageDown);
      visitor.finish_work();
    }
  }
  EXPECT_EQ(painter.sizes.size(), pictures) << "none is there twice";
  for (const auto& [name, size] : painter.sizes) {
    EXPECT_EQ(size.width, 1140) << name;
    EXPECT_NEAR(size.height, 712, 1) << name;
  }
}

TEST(Guide, NothingOfAnyPageIsCutOffAtAnySize) {
  for (const GuideSection section : {GuideSection::Overview, GuideSection::Operate,
                                     GuideSection::Inbox, GuideSection::Records}) {
    EXPECT_THAT(faults_at_every_size([] { return std::make_unique<SomePage>(); },
                                     [&](SomeVisitor& visitor) {
                                       visitor.shell().on_guide([section](GuideSection) {
                                         return std::make_unique<GuideScreen>(section);
                                       });
                                       visitor.driver().frame();
                                       visitor.driver().press(Key::F1);
                                       visitor.driver().press(Key::F1);
                                       ASSERT_TRUE(visitor.shell().is_guide_shown());
                                     }),
                IsEmpty());
  }
}

// Of a table and of paragraphs: no words over others, none beyond the page.
TEST(Guide, WordsStandBesideEachOtherAtAnyWidth) {
  const Texts texts = english_texts();
  const Guides guides;
  for (const float width : {220.0F, 400.0F, 760.0F}) {
    for (const GuidePage& page : guides.pages()) {
      FlowedPage flowed;
      Driver driver(texts, [&](Ui& ui) {
        flowed = flow_page(ui, page.blocks, width, &GuidePictures::size_of,
                           [](std::string_view) { return true; });
      });
      ASSERT_EQ(flowed.blocks.size(), page.blocks.size());
      for (std::size_t i = 0; i < flowed.words.size(); ++i) {
        const Rect& own = flowed.words[i].rect;
        EXPECT_LE(own.right(), width + 1.5F) << page.name << ": " << flowed.words[i].text;
        for (std::size_t j = i + 1; j < std::min(i + 60, flowed.words.size()); ++j) {
          const Rect shared = intersection(inset(own, 0.5F), inset(flowed.words[j].rect, 0.5F));
          EXPECT_TRUE(shared.is_empty())
              << page.name << ": " << flowed.words[i].text << " and " << flowed.words[j].text;
        }
      }
    }
  }
}

}  // namespace
}  // namespace hallux::ui
