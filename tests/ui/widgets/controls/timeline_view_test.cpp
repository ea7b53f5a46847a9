#include "ui/widgets/controls/timeline_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/ui/widgets/driver.h"

namespace hallux::ui {
namespace {

using testing::IsEmpty;

constexpr Rect line{40.0F, 60.0F, 1100.0F, 200.0F};

/// Ten minutes with 20 s of sawing: 150 events in one heap at 06:20, and a few beside.
Timeline ten_minutes() {
  Timeline shown{.duration_s = 603.0, .now_s = 380.0};
  shown.steps_name = "Steps", shown.events_name = "Events", shown.notes_name = "Notes";
  shown.steps = {{0, 120, "Verify"}, {120, 603, "Cut"}};
  shown.events.push_back({10.0, Meaning::Neutral, "Begun"});
  for (int i = 0; i < 150; ++i)
    shown.events.push_back(
        {380.0 + 0.13 * i, i % 50 == 7 ? Meaning::Bad : Meaning::Warn, "The saw kicked"});
  shown.events.push_back({590.0, Meaning::Good, "Finished"});
  shown.notes = {{100.0, "1", "Look first"},
                 {385.0, "2", "Slower here"},
                 {386.0, "", "Why?", TimelineShape::Question}};
  shown.legend = {{TimelineShape::Warn, "Warning"}, {TimelineShape::Bad, "Harm"}};
  return shown;
}

/// A timeline alone in a window.
struct Shown {
  Shown()
      : driver(texts, [this](Ui& ui) {
          timeline_bar(ui, "bar", {40.0F, 10.0F, 1100.0F, timeline_bar_height}, shown, state,
                       state.shows_legend.value_or(false));
          hear_timeline_keys(ui, shown, state);
          const TimelineAnswer answer = timeline(ui, "time", line, shown, state);
          if (answer.asked_s) shown.now_s = asked_s = answer.asked_s;
          if (answer.note) note = answer.note;
          if (state.shows_legend.value_or(false))
            draw_timeline_legend(ui, {40.0F, 300.0F, 1100.0F, 100.0F}, shown);
        }) {
    driver.settle();
  }

  TimelineLayout layout() const {
    Timeline as_shown = shown;
    as_shown.range = state.range;
    return layout_of(line, as_shown);
  }
  float x(double time_s) const { return layout().plot.x(time_s); }
  std::vector<std::string> marks() const {
    std::vector<std::string> ids;
    for (const Widget& widget : driver.content().widgets)
      if (widget.id.starts_with("time.")) ids.push_back(widget.id);
    return ids;
  }

  const Texts texts = english_texts();
  Timeline shown = ten_minutes();
  TimelineState state;
  std::optional<double> asked_s;
  std::optional<std::size_t> note;
  Driver driver;
};

TEST(TimelineView, AlwaysSaysWhichPartIsShown) {
  Shown view;
  EXPECT_TRUE(view.driver.sees("All of 10:03"));
  view.state.range = TimeRange{380.0, 412.0};
  view.driver.frame();
  EXPECT_TRUE(view.driver.sees("06:20 to 06:52 of 10:03"));
  EXPECT_EQ(view.driver.widget("time").label, "Time: 06:20 to 06:52 of 10:03")
      << "for those who do not see it";
  view.state.range = TimeRange{380.0, 381.5};
  view.driver.frame();
  EXPECT_TRUE(view.driver.sees("06:20.0 to 06:21.5 of 10:03"));
  EXPECT_THAT(view.driver.faults(), IsEmpty());
}

TEST(TimelineView, TheWheelZoomsAboutThePointer) {
  Shown view;
  const Point at{view.x(380.0), view.layout().events_y + 8.0F};
  view.driver.wheel(at, 5.0F);
  ASSERT_TRUE(view.state.range.has_value());
  EXPECT_LT(view.state.range->span_s(), 250.0);
  EXPECT_NEAR(view.x(380.0), at.x, 1.0F);
  view.driver.wheel(at, -20.0F);
  EXPECT_FALSE(view.state.range.has_value()) << "all of it again";
}

TEST(TimelineView, ADragMovesWhatIsZoomedAndLeadsThePlayheadElse) {
  Shown view;
  view.state.range = TimeRange{300.0, 400.0};
  view.driver.frame();
  const float y = view.layout().notes_y + 14.0F;
  view.driver.drag({600.0F, y}, {500.0F, y});
  EXPECT_GT(view.state.range->begin_s, 305.0);
  EXPECT_NEAR(view.state.range->span_s(), 100.0, 1.0e-9);
  EXPECT_FALSE(view.asked_s.has_value()) << "the moment stays";
  view.state.range.reset();
  view.driver.frame();
  view.driver.drag({600.0F, y}, {700.0F, y});
  ASSERT_TRUE(view.asked_s.has_value());
  EXPECT_NEAR(*view.asked_s, view.layout().plot.value_at(700.0F), 1.0);
}

TEST(TimelineView, WhereItIsZoomedStepsAxisAndPlayheadLeadThePlayhead) {
  Shown view;
  view.state.range = TimeRange{300.0, 400.0};
  view.driver.frame();
  const float steps = view.layout().steps.mid_y();
  view.driver.drag({600.0F, steps}, {650.0F, steps});
  ASSERT_TRUE(view.asked_s.has_value());
  EXPECT_EQ(view.state.range, (TimeRange{300.0, 400.0}));
  EXPECT_NEAR(*view.asked_s, view.layout().plot.value_at(650.0F), 0.1);
  const float notes = view.layout().notes_y + 14.0F;
  view.driver.drag({view.x(*view.shown.now_s), notes}, {400.0F, notes});
  EXPECT_NEAR(*view.asked_s, view.layout().plot.value_at(400.0F), 0.1);
}

TEST(TimelineView, AClickAsksForTheMomentAndADoubleClickShowsAll) {
  Shown view;
  view.state.range = TimeRange{300.0, 400.0};
  view.driver.frame();
  const Point at{view.x(350.0), view.layout().notes_y + 14.0F};
  view.driver.send(click_events(at));
  view.driver.settle();
  ASSERT_TRUE(view.asked_s.has_value());
  EXPECT_NEAR(*view.asked_s, 350.0, 0.2);
  EXPECT_TRUE(view.state.range.has_value());
  view.driver.send(click_events(at));
  view.driver.settle();
  EXPECT_FALSE(view.state.range.has_value());
}

TEST(TimelineView, KeysZoomMoveAndShowAll) {
  Shown view;
  for (int press = 0; press < 6; ++press) view.driver.press(Key::Plus);
  ASSERT_TRUE(view.state.range.has_value());
  EXPECT_TRUE(view.state.range->contains(380.0)) << "about the playhead";
  const TimeRange before = *view.state.range;
  view.driver.press(Key::Right, {.control = true});
  EXPECT_GT(view.state.range->begin_s, before.begin_s);
  view.driver.press(Key::Left, {.control = true});
  EXPECT_NEAR(view.state.range->begin_s, before.begin_s, 1.0e-6);
  view.driver.press(Key::Minus);
  EXPECT_GT(view.state.range->span_s(), before.span_s());
  view.driver.press(Key::Digit0);
  EXPECT_FALSE(view.state.range.has_value());
  std::set<std::string> listed;
  for (const Shortcut& each : view.driver.ui().shortcuts()) listed.insert(each.label);
  for (const char* words : {"Time: nearer", "Time: farther", "Time: all of it"})
    EXPECT_TRUE(listed.contains(words)) << words << " is not under F1";
}

TEST(TimelineView, ButtonsDoTheSameAndAreThereOnlyWhereTheyDoSomething) {
  Shown view;
  EXPECT_FALSE(view.driver.has("bar.all"));
  EXPECT_FALSE(view.driver.has("bar.farther"));
  view.driver.click("bar.nearer");
  EXPECT_TRUE(view.state.range.has_value());
  view.driver.click("bar.farther");
  EXPECT_FALSE(view.state.range.has_value());
  for (int i = 0; i < 30 && view.driver.has("bar.nearer"); ++i) view.driver.click("bar.nearer");
  EXPECT_FALSE(view.driver.has("bar.nearer"));
  EXPECT_NEAR(view.state.range->span_s(), least_span_s, 1.0e-9);
  view.driver.click("bar.all");
  EXPECT_FALSE(view.state.range.has_value());
}

TEST(TimelineView, AHeapOfMarksIsOneWithItsNumberAndOpensByAPress) {
  Shown view;
  EXPECT_LT(view.marks().size(), 12U) << "of 155 marks";
  EXPECT_TRUE(view.driver.sees("150"));
  EXPECT_EQ(view.driver.widget("time.event.2").label, "150 events, press to open, 06:20 to 06:39");
  view.driver.click("time.event.2");
  ASSERT_TRUE(view.state.range.has_value());
  EXPECT_LE(view.state.range->begin_s, 380.0);
  EXPECT_GE(view.state.range->end_s, 399.0);
  EXPECT_FALSE(view.asked_s.has_value());
  EXPECT_GT(view.marks().size(), 20U) << "they come apart";
  // Near enough each stands alone, and is looked at.
  view.state.range = TimeRange{379.9, 380.9};
  view.driver.frame();
  view.driver.click("time.event.3");
  EXPECT_NEAR(view.asked_s.value_or(0.0), 380.13, 1.0e-6);
}

TEST(TimelineView, WhatHappenedInOneInstantIsLookedAtAndNotOpenedForEver) {
  Shown view;
  view.shown.events = {{100.0, Meaning::Warn, "a"}, {100.0, Meaning::Bad, "b"}};
  view.shown.now_s = 0.0;
  view.driver.frame();
  for (int press = 0; press < 2; ++press) {
    view.driver.settle();
    view.driver.click("time.event.1");
  }
  EXPECT_EQ(view.asked_s, 100.0);
}

TEST(TimelineView, MarksNeverLieOverEachOther) {
  Shown view;
  for (const double span_s : {603.0, 200.0, 50.0, 20.0, 5.0, 1.0}) {
    view.state.range = around(380.0, 380.0 + span_s, 603.0);
    view.driver.settle();
    const std::vector<MarkCluster> clusters = event_marks(view.layout(), [&] {
      Timeline as_shown = view.shown;
      as_shown.range = view.state.range;
      return as_shown;
    }());
    for (std::size_t i = 1; i < clusters.size(); ++i)
      EXPECT_GT(clusters[i].x - clusters[i].half_width,
                clusters[i - 1].x + clusters[i - 1].half_width);
    EXPECT_THAT(view.driver.faults(), IsEmpty()) << span_s;
  }
}

TEST(TimelineView, MarksAreReachedByKeyboardAlone) {
  Shown view;
  for (int presses = 0; presses < 20 && view.driver.focused() != "time.note.1"; ++presses)
    view.driver.press(Key::Tab);
  ASSERT_EQ(view.driver.focused(), "time.note.1");
  view.driver.press(Key::Enter);
  EXPECT_EQ(view.asked_s, 100.0);
  EXPECT_EQ(view.note, 0U);
  view.driver.press(Key::Right);
  EXPECT_EQ(view.driver.widget("time.note.2").label, "2 notes, press to open, 06:25 to 06:26");
  view.driver.press(Key::Enter);
  EXPECT_TRUE(view.state.range.has_value());
}

TEST(TimelineView, ThePlayheadIsKeptInSightAndTheRangeStaysWhereItWasMoved) {
  Shown view;
  view.state.range = TimeRange{370.0, 390.0};
  view.driver.frame();
  view.shown.now_s = 395.0;
  view.driver.frame();
  EXPECT_TRUE(view.state.range->contains(395.0));
  view.state.range = TimeRange{100.0, 120.0};
  view.driver.settle();
  EXPECT_EQ(view.state.range, (TimeRange{100.0, 120.0})) << "nobody moved the playhead";
}

TEST(TimelineView, TheStripLeadsThere) {
  Shown view;
  view.state.range = TimeRange{0.0, 60.0};
  view.driver.frame();
  const Rect strip = view.layout().overview;
  view.driver.drag({strip.x + 10.0F, strip.mid_y()}, {strip.mid_x(), strip.mid_y()});
  EXPECT_NEAR(0.5 * (view.state.range->begin_s + view.state.range->end_s), 301.5, 2.0);
  EXPECT_NEAR(view.state.range->span_s(), 60.0, 1.0e-9);
}

TEST(TimelineView, TheLegendSaysWhatTheMarksMean) {
  Shown view;
  EXPECT_FALSE(view.driver.sees("Harm"));
  view.driver.click("bar.legend");
  EXPECT_TRUE(view.driver.sees("Harm"));
  view.driver.click("bar.legend");
  EXPECT_FALSE(view.driver.sees("Harm"));
}

TEST(TimelineView, HoveringSaysWhatItIs) {
  Shown view;
  view.driver.move_to({view.x(590.0), view.layout().events_y});
  EXPECT_TRUE(view.driver.sees("Finished"));
  EXPECT_TRUE(view.driver.sees("09:50"));
}

}  // namespace
}  // namespace hallux::ui
