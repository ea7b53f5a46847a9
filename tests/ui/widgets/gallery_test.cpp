// Every component at every content scale: nothing cut off, every control reached by the keyboard,
// random use survived.
#include "tests/ui/widgets/gallery.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

struct Page {
  const char* name;
  void (*draw)(Ui&, GalleryState&);
};
constexpr Page pages[] = {{"Components", draw_components}, {"LargerParts", draw_larger_parts}};

struct Case {
  Page page;
  float scale;
};

class Gallery : public testing::TestWithParam<Case> {
 protected:
  const Texts texts_ = english_texts();
  GalleryState state_;

  // A window in which the whole page is in sight.
  Driver driver_at(float scale, ThemeName theme = ThemeName::Light) {
    return Driver(texts_, [this](Ui& ui) { GetParam().page.draw(ui, state_); },
                  {1440.0F * scale, 1434.0F * scale, scale, theme});
  }
};

TEST_P(Gallery, CutsNoTextOff) {
  for (const ThemeName theme : {ThemeName::Light, ThemeName::Dark})
    EXPECT_THAT(driver_at(GetParam().scale, theme).faults(), IsEmpty());
}

TEST_P(Gallery, OverlaysCutNoTextOff) {
  state_.has_menu = true;
  EXPECT_THAT(driver_at(GetParam().scale).faults(), IsEmpty());
  state_.has_menu = false;
  state_.has_question = true;
  EXPECT_THAT(driver_at(GetParam().scale).faults(), IsEmpty());
}

// Tab reaches every single control and one of each group; arrows reach the rest of it.
TEST_P(Gallery, TheKeyboardReachesEveryControl) {
  Driver driver = driver_at(GetParam().scale);
  std::set<std::string> wanted, reached, groups;
  for (const Widget& widget : driver.content().widgets)
    if (widget.is_enabled && widget.is_focusable) wanted.insert(widget.id);
  for (int tab = 0; tab < 200; ++tab) {
    driver.press(Key::Tab);
    const Widget here = driver.widget(driver.focused());
    const bool is_new = reached.insert(here.id).second;
    if (!is_new && tab > 3) break;
    if (here.group.empty()) continue;
    driver.press(Key::Home);
    for (const Key arrow : {Key::Right, Key::Down})
      for (int step = 0; step < 70; ++step) {
        reached.insert(driver.focused());
        driver.press(arrow);
      }
  }
  for (const std::string& id : wanted) EXPECT_TRUE(reached.contains(id)) << id;
}

TEST_P(Gallery, BackwardsIsForwardsReversed) {
  Driver driver = driver_at(GetParam().scale);
  std::vector<std::string> forwards, backwards;
  driver.press(Key::Tab);
  const std::string first = driver.focused();
  do {
    forwards.push_back(driver.focused());
    driver.press(Key::Tab);
  } while (driver.focused() != first && forwards.size() < 100);
  do {
    driver.press(Key::Tab, {.shift = true});
    backwards.push_back(driver.focused());
  } while (driver.focused() != first && backwards.size() < 100);
  std::reverse(backwards.begin(), backwards.end());
  EXPECT_EQ(forwards, backwards);
}

TEST_P(Gallery, RandomUseIsSurvivedAndLeavesNoFault) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random()) % count; };
  Driver driver = driver_at(GetParam().scale);
  constexpr Key keys[] = {Key::Tab,  Key::Enter, Key::Space, Key::Escape, Key::Up, Key::Down,
                          Key::Left, Key::Right, Key::End,   Key::Delete, Key::A};
  for (int step = 0; step < 400; ++step) {
    const auto& widgets = driver.content().widgets;
    switch (below(5)) {
      case 0:
        driver.press(keys[below(std::size(keys))], {below(4) == 0, below(4) == 0, false});
        break;
      case 1:
        driver.type("a\xC3\xBC 1");
        break;
      case 2: {
        const Widget target = widgets[below(widgets.size())];
        driver.send(click_events({target.rect.mid_x() * driver.ui().scale(),
                                  target.rect.mid_y() * driver.ui().scale()}));
        driver.settle();
        break;
      }
      case 3:
        driver.wheel({static_cast<float>(below(1440)), static_cast<float>(below(900))},
                     below(2) == 0 ? 1.0F : -1.0F);
        break;
      default:
        driver.drag({static_cast<float>(below(1440)), static_cast<float>(below(900))},
                    {static_cast<float>(below(1440)), static_cast<float>(below(900))});
    }
    if (step % 40 == 0) {
      ASSERT_THAT(driver.faults(), IsEmpty()) << "after step " << step;
    }
  }
  EXPECT_THAT(driver.faults(), IsEmpty());
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (const Page& page : pages)
    for (const float scale : {0.8F, 1.0F, 1.5F, 2.0F}) cases.push_back({page, scale});
  return cases;
}

INSTANTIATE_TEST_SUITE_P(AtEveryScale, Gallery, testing::ValuesIn(all_cases()),
                         [](const auto& tested) {
                           return tested.param.page.name + std::to_string(static_cast<int>(
                                                               tested.param.scale * 100.0F + 0.5F));
                         });

}  // namespace
}  // namespace hallux::ui
