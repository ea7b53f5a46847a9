#include "ui/window/shell/background.h"

#include <gtest/gtest.h>

#include <chrono>
#include <stdexcept>

namespace hallux::ui {
namespace {

/// Collects until the work has ended; at most ten seconds.
void collect_all(Background& background) {
  for (int step = 0; step < 10000 && !background.is_idle(); ++step) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    background.collect();
  }
}

TEST(Background, TellsTheEndOnTheThreadThatCollects) {
  std::atomic<int> wakes = 0;
  Background background([&] { ++wakes; });
  std::thread::id worked_on, finished_on;
  WorkEnd end = WorkEnd::Failed;
  background.start(
      "Adding",
      [&](WorkReport& report) { worked_on = std::this_thread::get_id(), report.reached(0.5); },
      [&](WorkEnd ended, const std::string&) {
        finished_on = std::this_thread::get_id(), end = ended;
      });
  collect_all(background);
  EXPECT_EQ(end, WorkEnd::Done);
  EXPECT_EQ(finished_on, std::this_thread::get_id());
  EXPECT_NE(worked_on, finished_on);
  EXPECT_EQ(wakes, 1);
}

TEST(Background, ACancelledWorkHearsIt) {
  Background background;
  WorkEnd end = WorkEnd::Done;
  background.start(
      "Waiting",
      [](WorkReport& report) {
        while (report.reached(0.25)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      },
      [&](WorkEnd ended, const std::string&) { end = ended; });
  const auto running = background.running();
  ASSERT_EQ(running.size(), 1U);
  EXPECT_EQ(running.front().label, "Waiting");
  background.cancel(running.front().id);
  collect_all(background);
  EXPECT_EQ(end, WorkEnd::Cancelled);
}

TEST(Background, AFailureComesWithItsSentence) {
  Background background;
  std::string reason;
  background.start(
      "Failing", [](WorkReport&) { throw std::runtime_error("the disk is full"); },
      [&](WorkEnd end, const std::string& told) {
        reason = end == WorkEnd::Failed ? told : "not failed";
      });
  collect_all(background);
  EXPECT_EQ(reason, "the disk is full");
}

TEST(Background, AnEndMayStartTheNextWork) {
  Background background;
  int ends = 0;
  background.start(
      "First", [](WorkReport&) {},
      [&](WorkEnd, const std::string&) {
        ++ends;
        background.start(
            "Second", [](WorkReport&) {}, [&](WorkEnd, const std::string&) { ++ends; });
      });
  collect_all(background);
  EXPECT_EQ(ends, 2);
}

TEST(Background, ItsEndCancelsAndWaits) {
  std::atomic<bool> has_ended = false;
  {
    Background background;
    background.start(
        "Long",
        [&](WorkReport& report) {
          while (report.reached(0.0)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
          has_ended = true;
        },
        [](WorkEnd, const std::string&) { FAIL() << "nobody is there to be told"; });
  }
  EXPECT_TRUE(has_ended);
}

}  // namespace
}  // namespace hallux::ui
