// How events become presses, edits and focus: nothing a person did may be lost, whatever meets one
// frame.
#include "ui/widgets/ui.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "tests/ui/widgets/driver.h"
#include "ui/widgets/controls/button.h"
#include "ui/widgets/controls/choice.h"
#include "ui/widgets/controls/field.h"
#include "ui/widgets/controls/menu.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

const Texts& no_texts() {
  static const Texts texts = english_texts();
  return texts;
}

void append(std::vector<InputEvent>& events, const std::vector<InputEvent>& more) {
  events.insert(events.end(), more.begin(), more.end());
}

void append_typing(std::vector<InputEvent>& events, std::string_view letters) {
  for (const char letter : letters)
    events.push_back(character_event(static_cast<char32_t>(letter)));
}

/// A sign-in form, whose button waits for both fields, that leads to a page with a search field.
struct TwoPages {
  std::string login, password, search;
  bool is_in = false;
  int sign_ins = 0;

  void draw(Ui& ui) {
    if (is_in) {
      field(ui, "home.search", {20, 60, 300, 42}, search, {"Search"});
      ui.focus_first("home.search");
      return;
    }
    field(ui, "form.login", {20, 60, 300, 42}, login, {"Login"});
    FieldSpec secret{"Password"};
    secret.is_secret = true;
    field(ui, "form.password", {20, 150, 300, 42}, password, secret);
    ui.focus_first("form.login");
    ButtonSpec submit{"Sign in", ButtonLook::Primary};
    if (login.empty() || password.empty()) submit.why_off = "Login and password first";
    if (button(ui, "form.submit", {20, 220, 300, 44}, submit)) is_in = true, ++sign_ins;
  }
};

TEST(Events, AWholeSignInAndTheNextPageMayMeetOneFrame) {
  TwoPages pages;
  Driver driver(no_texts(), [&](Ui& ui) { pages.draw(ui); });
  std::vector<InputEvent> events;
  append_typing(events, "trainee-12");
  append(events, key_events(Key::Tab));
  append_typing(events, "secret");
  append(events, key_events(Key::Enter));
  append_typing(events, "akin");  // typed ahead: belongs to the page that Enter leads to
  driver.send(events);
  driver.settle();
  EXPECT_EQ(pages.login, "trainee-12");
  EXPECT_EQ(pages.password, "secret");
  EXPECT_EQ(pages.sign_ins, 1);
  EXPECT_EQ(pages.search, "akin");
}

TEST(Events, EveryClickOfOneFrameCounts) {
  int first = 0, second = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    if (button(ui, "a", {10, 10, 100, 38}, {"First"})) ++first;
    if (button(ui, "b", {10, 60, 100, 38}, {"Second"})) ++second;
  });
  std::vector<InputEvent> events;
  for (int round = 0; round < 5; ++round) {
    append(events, click_events({30, 30}));
    append(events, click_events({30, 80}));
  }
  driver.send(events);
  driver.settle();
  EXPECT_EQ(first, 5);
  EXPECT_EQ(second, 5);
}

TEST(Events, AClickBesideWhereItBeganPressesNothing) {
  int presses = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    if (button(ui, "a", {10, 10, 100, 38}, {"First"})) ++presses;
    if (button(ui, "b", {10, 60, 100, 38}, {"Second"})) ++presses;
  });
  driver.drag({30, 30}, {30, 80});
  EXPECT_EQ(presses, 0);
  driver.drag({30, 30}, {60, 35});
  EXPECT_EQ(presses, 1) << "moving inside it is still a press";
}

TEST(Events, DisabledAndBusyControlsAreNotPressed) {
  int presses = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    ButtonSpec off{"Off", ButtonLook::Primary}, busy{"Busy", ButtonLook::Primary};
    off.why_off = "Nothing to do";
    busy.is_busy = true;
    if (button(ui, "off", {10, 10, 100, 38}, off)) ++presses;
    if (button(ui, "busy", {10, 60, 100, 38}, busy)) ++presses;
  });
  driver.send(click_events({30, 30}));
  driver.send(click_events({30, 80}));
  driver.press(Key::Enter);
  EXPECT_EQ(driver.focused(), "") << "by pointer they take nothing";
  for (const char* id : {"off", "busy"}) {
    driver.press(Key::Tab);
    EXPECT_EQ(driver.focused(), id);
    driver.press(Key::Space);
    driver.press(Key::Enter);
  }
  EXPECT_EQ(presses, 0);
}

TEST(Events, TheRingComesWithTabAndGoesWithTheMouse) {
  int presses = 0;
  bool has_ring = false;
  Driver driver(no_texts(), [&](Ui& ui) {
    Widget widget;
    widget.id = "a", widget.label = "A", widget.rect = {10, 10, 100, 38};
    const Response response = ui.control(widget);
    has_ring = response.shows_ring;
    presses += response.is_pressed() ? 1 : 0;
  });
  driver.press(Key::Tab);
  EXPECT_TRUE(has_ring);
  driver.press(Key::Space);
  EXPECT_EQ(presses, 1);
  driver.click("a");
  EXPECT_FALSE(has_ring);
  driver.press(Key::Space);
  EXPECT_EQ(presses, 2) << "after the mouse Space belongs to the screen";
}

TEST(Events, ShortcutsStayOutOfFieldsAndFromUnderQuestions) {
  std::string name;
  int flags = 0, helps = 0;
  bool is_asking = false;
  Driver driver(no_texts(), [&](Ui& ui) {
    field(ui, "name", {10, 40, 200, 42}, name, {"Name"});
    if (ui.shortcut({Key::F}, "flag")) ++flags;
    if (ui.shortcut({Key::F1}, "help")) ++helps;
    if (is_asking &&
        question(ui, "ask", {"Sure?", "All of it.", "Erase", "Keep"}) != Answer::Waiting)
      is_asking = false;
  });
  driver.press(Key::F);
  EXPECT_EQ(flags, 1);
  driver.click("name");
  driver.press(Key::F);
  driver.press(Key::F1);
  EXPECT_EQ(flags, 1) << "a letter belongs to the field";
  EXPECT_EQ(helps, 1);
  is_asking = true;
  driver.frame();
  driver.settle();
  driver.press(Key::F1);
  EXPECT_EQ(helps, 1) << "the question lies above";
  driver.press(Key::Escape);
  EXPECT_FALSE(is_asking);
  EXPECT_EQ(driver.focused(), "name") << "the focus goes back";
  EXPECT_EQ(driver.ui().shortcuts().size(), 2U);
}

TEST(Events, AQuestionHoldsTheFocusOnItsSafeAnswer) {
  bool is_asking = true;
  Answer last = Answer::Waiting;
  int below = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    if (button(ui, "below", {10, 10, 100, 38}, {"Below", ButtonLook::Primary})) ++below;
    if (!is_asking) return;
    last = question(ui, "ask",
                    {"Erase Trainee 12?", "14 attempts are gone for good.", "Erase", "Keep"});
    if (last != Answer::Waiting) is_asking = false;
  });
  EXPECT_EQ(driver.focused(), "ask.keep");
  driver.press(Key::Enter);
  EXPECT_EQ(last, Answer::Keep);
  EXPECT_EQ(below, 0);
  is_asking = true;
  driver.frame();
  driver.settle();
  driver.press(Key::Tab);
  EXPECT_EQ(driver.focused(), "ask.act");
  driver.press(Key::Tab);
  EXPECT_EQ(driver.focused(), "ask.keep") << "Tab stays inside";
  driver.send(click_events({30, 30}));
  driver.settle();
  EXPECT_EQ(below, 0) << "what lies below cannot be pressed";
  driver.click("ask.act");
  EXPECT_EQ(last, Answer::Act);
}

TEST(Events, AMenuIsWalkedByArrowsAndClosedBesideIt) {
  bool is_open = true;
  int chosen = menu_open;
  constexpr std::array<MenuItem, 3> items{
      {{"Replay"}, {"Compare"}, {"Withdraw", Icon::Delete, "Del", true}}};
  Driver driver(no_texts(), [&](Ui& ui) {
    if (!is_open) return;
    const int answer = menu(ui, "menu", {100, 100}, items);
    if (answer != menu_open) chosen = answer, is_open = false;
  });
  driver.press(Key::Down);
  driver.press(Key::Down);
  driver.press(Key::Enter);
  EXPECT_EQ(chosen, 2);
  is_open = true;
  driver.frame();
  driver.settle();
  driver.send(click_events({700, 700}));
  driver.settle();
  EXPECT_EQ(chosen, menu_closed);
}

TEST(Fields, AreEditedByMouseAndKeys) {
  std::string name = "hello world";
  Driver driver(no_texts(), [&](Ui& ui) { field(ui, "name", {10, 40, 300, 42}, name, {"Name"}); });
  driver.double_click("name");
  driver.send(click_events({30, 60}));
  driver.send(click_events({30, 60}));
  driver.settle();
  driver.type("bye");
  EXPECT_EQ(name, "bye world");
  driver.drag({24, 60}, {600, 60});
  driver.press(Key::C, {.control = true});
  EXPECT_EQ(driver.clipboard().read(), "bye world");
  driver.press(Key::Delete);
  EXPECT_EQ(name, "");
}

TEST(Fields, TypedTextIsSeenAndASecretIsNot) {
  TwoPages pages;
  Driver driver(no_texts(), [&](Ui& ui) { pages.draw(ui); });
  driver.type("trainee-12");
  driver.press(Key::Tab);
  driver.type("geheim");
  EXPECT_TRUE(driver.sees("trainee-12"));
  EXPECT_FALSE(driver.sees("geheim"));
  driver.click("form.password.eye");
  EXPECT_THAT(driver.faults(), IsEmpty());
}

TEST(Fields, SeveralLinesBreakAndAreWalkedUpAndDown) {
  std::string note;
  int sent = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    FieldSpec spec{"Note"};
    spec.lines = 3;
    spec.max_bytes = 500;
    field(ui, "note", {10, 40, 220, 90}, note, spec);
    ui.focus_first("note");
    if (button(ui, "send", {10, 150, 100, 38}, {"Send", ButtonLook::Primary})) ++sent;
  });
  driver.type("first");
  driver.press(Key::Enter);
  driver.type("second");
  driver.press(Key::Up);
  driver.type("X");
  EXPECT_EQ(note, "firstX\nsecond");
  driver.type(" and words that need more room than one line has, and more than three");
  EXPECT_EQ(sent, 0);
  driver.press(Key::Enter, {.control = true});
  EXPECT_EQ(sent, 1);
}

TEST(Groups, ArrowsMoveAndSpaceChooses) {
  constexpr std::array<std::string_view, 3> labels{"State", "Best", "Trend"};
  int chosen = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    segmented(ui, "view", {10, 10, 300, 36}, labels, chosen);
  });
  driver.press(Key::Tab);
  EXPECT_EQ(driver.focused(), "view.0");
  driver.press(Key::Right);
  EXPECT_EQ(driver.focused(), "view.1");
  EXPECT_EQ(chosen, 0);
  driver.press(Key::Space);
  EXPECT_EQ(chosen, 1);
  driver.click("view.2");
  EXPECT_EQ(chosen, 2);
}

TEST(Scrolling, TheWheelAndTheFocusBringTheEndIntoSight) {
  int pressed = -1;
  Driver driver(no_texts(), [&](Ui& ui) {
    const float offset = ui.begin_scroll("list", "List", {0, 0, 400, 300}, 2000);
    for (int row = 0; row < 40; ++row)
      if (button(ui, "row." + std::to_string(row),
                 {20, 10.0F + 50.0F * static_cast<float>(row) - offset, 200, 38}, {"Press"}))
        pressed = row;
    ui.end_scroll();
  });
  driver.click("row.39");
  EXPECT_EQ(pressed, 39);
  driver.click("row.0");
  EXPECT_EQ(pressed, 0);
  for (int tab = 0; tab < 25; ++tab) driver.press(Key::Tab);
  EXPECT_GE(driver.widget(driver.focused()).visible.h, 38.0F) << driver.focused();
  EXPECT_NE(driver.focused(), "row.0");
}

TEST(Areas, TellDragsClicksAndWheel) {
  AreaResponse seen;
  Point dragged;
  int clicks = 0;
  float wheel = 0.0F;
  Driver driver(no_texts(), [&](Ui& ui) {
    seen = ui.area("view", "View", {0, 0, 400, 300});
    dragged.x += seen.dragged[1].x, dragged.y += seen.dragged[1].y;
    clicks += seen.clicked[0] ? 1 : 0;
    wheel += seen.wheel;
  });
  driver.drag({100, 100}, {160, 130}, MouseButton::Right);
  EXPECT_EQ(dragged, (Point{60, 30}));
  EXPECT_EQ(clicks, 0);
  driver.send(click_events({50, 50}));
  driver.settle();
  EXPECT_EQ(clicks, 1);
  driver.wheel({50, 50}, -2.0F);
  EXPECT_EQ(wheel, -2.0F);
}

TEST(Frames, AnIdleScreenAsksForNone) {
  int frames = 0;
  Driver driver(no_texts(), [&](Ui& ui) {
    ++frames;
    button(ui, "a", {10, 10, 100, 38}, {"First"});
  });
  driver.ui().set_reduced_motion(false);
  driver.move_to({30, 30});
  driver.wait(1.0);
  const int before = frames;
  EXPECT_EQ(driver.ui().next_frame_in_s(), std::numeric_limits<double>::infinity());
  driver.wait(60.0);
  EXPECT_LE(frames - before, 1);
}

TEST(Frames, TheFocusLostReleasesWhatIsHeld) {
  AreaResponse seen;
  Driver driver(no_texts(), [&](Ui& ui) { seen = ui.area("view", "View", {0, 0, 400, 300}); });
  InputEvent press;
  press.kind = EventKind::ButtonPressed;
  press.position = {50, 50};
  press.button = MouseButton::Right;
  driver.send({press});
  driver.frame();
  EXPECT_TRUE(seen.is_down[1]);
  InputEvent lost;
  lost.kind = EventKind::FocusLost;
  driver.send({lost});
  driver.frame();
  EXPECT_FALSE(seen.is_down[1]);
}

TEST(Frames, ATinyWindowHarmsNothing) {
  TwoPages pages;
  Driver driver(no_texts(), [&](Ui& ui) { pages.draw(ui); });
  for (const float size : {1.0F, 0.0F, 7.0F, 5000.0F, 1.0F}) driver.resize(size, size);
  driver.resize(1440, 900);
  driver.type("still here");
  EXPECT_EQ(pages.login, "still here");
}

TEST(Frames, ManyTextsOutgrowSixteenBitsOfVertices) {
  Driver driver(no_texts(), [&](Ui& ui) {
    for (int row = 0; row < 400; ++row)
      ui.canvas().text({10, static_cast<float>(row)}, {Type::Body, ui.theme().text},
                       std::string(60, 'x'));
  });
  EXPECT_EQ(driver.texts().size(), 400U);
}

/// A short list inside a page that is lower than its content.
struct ListInPage {
  void draw(Ui& ui) {
    const float page = ui.begin_scroll("page", "Page", {0.0F, 0.0F, 600.0F, 300.0F}, 900.0F);
    const Rect view{20.0F, 500.0F - page, 400.0F, 160.0F};
    const float list = ui.begin_scroll("list", "List", view, 400.0F);
    for (int row = 0; row < 10; ++row)
      button(ui, "row." + std::to_string(row),
             {24.0F, view.y - list + 40.0F * static_cast<float>(row) + 4.0F, 200.0F, 32.0F},
             {"Row"});
    ui.end_scroll();
    ui.end_scroll();
  }
};

TEST(Scroll, ARegionInsideAnotherIsBroughtIntoSightWithTheFocus) {
  const Texts texts = english_texts();
  ListInPage page;
  Driver driver(texts, [&](Ui& ui) { page.draw(ui); }, {600.0F, 300.0F, 1.0F});
  for (int tab = 0; tab < 10; ++tab) {
    driver.press(Key::Tab);
    driver.frame();
    driver.frame();
    EXPECT_FALSE(driver.widget("row." + std::to_string(tab)).visible.is_empty()) << tab;
  }
}

TEST(Scroll, ARegionAtItsEndPassesTheWheelToTheOneAroundIt) {
  const Texts texts = english_texts();
  ListInPage page;
  Driver driver(texts, [&](Ui& ui) { page.draw(ui); }, {600.0F, 300.0F, 1.0F});
  const auto top_of = [&](std::string_view id) { return driver.widget(id).rect.y; };
  driver.wheel({200.0F, 200.0F}, -6.0F);  // the list comes under the pointer
  const float list = top_of("list"), row = top_of("row.0");
  const Point inside{200.0F, list + 40.0F};
  driver.wheel(inside, -1.0F);
  EXPECT_EQ(top_of("list"), list) << "first the list";
  EXPECT_LT(top_of("row.0"), row);
  for (int turn = 0; turn < 8; ++turn) driver.wheel(inside, -1.0F);
  EXPECT_LT(top_of("list"), list) << "then the page around it";
  const float lowest = top_of("list");
  for (int turn = 0; turn < 40; ++turn) driver.wheel({200.0F, 290.0F}, -1.0F);
  driver.wheel({200.0F, 20.0F}, 1.0F);
  EXPECT_GE(top_of("list"), lowest - 600.0F) << "and nothing beyond its own end";
}

TEST(Scroll, AnAreaThatTurnsNothingLeavesTheWheelToThePage) {
  const Texts texts = english_texts();
  float turned = 0.0F, offset = 0.0F;
  Driver driver(texts, [&](Ui& ui) {
    offset = ui.begin_scroll("page", "Page", {0.0F, 0.0F, 600.0F, 300.0F}, 900.0F);
    ui.area("chart", "Chart", {0.0F, 0.0F - offset, 600.0F, 150.0F}, false);
    turned += ui.area("bone", "Bone", {0.0F, 150.0F - offset, 600.0F, 150.0F}).wheel;
    ui.end_scroll();
  });
  driver.wheel({100.0F, 200.0F}, -1.0F);
  EXPECT_EQ(turned, -1.0F);
  EXPECT_EQ(offset, 0.0F);
  driver.wheel({100.0F, 50.0F}, -1.0F);
  EXPECT_GT(offset, 0.0F);
}

TEST(Texts, ThatHadNoRoomAreToldWholeOnceThePointerRestsOnThem) {
  const Texts texts = english_texts();
  const std::string name = "Wolfeschlegelsteinhausenbergerdorff the younger, of the second cohort";
  Driver driver(texts, [&](Ui& ui) {
    ui.canvas().text_in({20.0F, 20.0F, 120.0F, 24.0F}, {Type::Body, ui.theme().text}, name, true);
    ui.canvas().text_in({20.0F, 60.0F, 400.0F, 24.0F}, {Type::Body, ui.theme().text}, "14:05",
                        false, "14:05 +01:00");
  });
  const auto is_told = [&](std::string_view words) {
    for (const SeenText& seen : driver.content().texts)
      if (seen.layer == Layer::Tooltip && words.find(seen.text) != std::string::npos) return true;
    return false;
  };
  driver.move_to({60.0F, 32.0F});
  EXPECT_FALSE(is_told(name)) << "not in passing";
  driver.wait(1.0);
  EXPECT_TRUE(is_told(name));
  EXPECT_THAT(driver.faults(), IsEmpty());
  driver.move_to({40.0F, 72.0F});
  EXPECT_FALSE(is_told(name));
  driver.wait(1.0);
  EXPECT_TRUE(is_told("14:05 +01:00"));
}

TEST(Fields, TabGoesFromAPasswordToTheButtonAndToTheEyeLast) {
  TwoPages pages;
  pages.login = "ada", pages.password = "secret words";
  Driver driver(no_texts(), [&](Ui& ui) { pages.draw(ui); });
  driver.click("form.password");
  driver.press(Key::Tab);
  EXPECT_EQ(driver.focused(), "form.submit");
  driver.press(Key::Tab);
  EXPECT_EQ(driver.focused(), "form.password.eye");
  driver.press(Key::Tab);
  EXPECT_EQ(driver.focused(), "form.login");
}

}  // namespace
}  // namespace hallux::ui
