/// Recordings that end too soon or tell too little, through the whole assessment.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <string>

#include "assessment/measurement.h"
#include "scenarios/metric_names.h"
#include "tests/assessment/examined_attempt.h"

namespace hallux::assessment {
namespace {

using simulator::CutEventKind;
using simulator::Recording;
using simulator::ToolStatus;
using testing::examined;
using testing::ExaminedAttempt;

constexpr std::int64_t full_score_milli = 100000;

/// An item for each metric of the attempt and of all zones, beside those of the worked example.
scenarios::Scenario everything_counts(scenarios::Scenario scenario) {
  for (const scenarios::MetricName& metric : scenarios::known_metrics()) {
    const bool is_of_attempt = metric.subject == scenarios::MetricSubject::Attempt ||
                               metric.subject == scenarios::MetricSubject::Zone;
    if (!is_of_attempt) continue;
    scenarios::RubricItem item;
    item.id = item.title = item.metric = std::string(metric.name);
    item.group = "safety";
    item.unit = std::string(metric.unit);
    item.weight_milli = 1000;
    item.full = 1.0;
    item.zero = 3.0;
    scenario.rubric.items.push_back(item);
  }
  return scenario;
}

void expect_finite(const Measurement& each) {
  const std::string name = each.metric + " " + each.cut + each.hinge + each.zone;
  EXPECT_TRUE(std::isfinite(each.value)) << name;
  EXPECT_TRUE(std::isfinite(each.bound)) << name;
  EXPECT_TRUE(std::isfinite(each.done_fraction)) << name;
  EXPECT_GE(each.done_fraction, 0.0) << name;
  EXPECT_LE(each.done_fraction, 1.0) << name;
  EXPECT_TRUE(is_finite(each.place_in_bone_mm)) << name;
  EXPECT_LE(each.start_us, each.end_us) << name;
  EXPECT_EQ(each.is_measured(), reason_of(each.absence).empty()) << name;
}

void expect_sound(const ExaminedAttempt& made) {
  EXPECT_FALSE(made.examination.measurements.empty());
  for (const Measurement& each : made.examination.measurements) expect_finite(each);
  const database::ScoreCard& card = made.examination.card;
  std::int64_t lost_milli = 0;
  for (const database::LedgerLine& line : card.ledger) {
    EXPECT_TRUE(std::isfinite(line.value)) << line.metric;
    EXPECT_GE(line.points_lost_milli, 0) << line.metric;
    EXPECT_FALSE(line.text.find("nan") != std::string::npos) << line.text;
    lost_milli += line.points_lost_milli;
  }
  EXPECT_EQ(card.earned_milli + lost_milli, card.measured_milli);
  EXPECT_EQ(card.score_milli + std::accumulate(card.shown_losses_milli.begin(),
                                               card.shown_losses_milli.end(), std::int64_t{0}),
            full_score_milli);
}

/// With and without joints, on both bones, as nothing but these samples and events were kept.
void expect_sound_on_both(const Recording& of_block, const Recording& of_akin) {
  expect_sound(
      examined(everything_counts(testing::block_scenario()), testing::block_bone(), of_block));
  expect_sound(
      examined(everything_counts(testing::akin_with_deeds()), testing::oval_bone(), of_akin));
}

Recording block_recording(const std::vector<testing::Stroke>& strokes) {
  Recording recording;
  for (const testing::Stroke& stroke : strokes)
    add_stroke(recording, testing::block_bone(), stroke);
  return recording;
}

/// Started with the first sample, all of it running, with a tape in which the handle is at the
/// tool.
void tell_all(Recording& recording) {
  for (simulator::ToolSample& sample : recording.samples) {
    sample.status |= bit(ToolStatus::Running);
    simulator::TapeLine line;
    line.tick = sample.tick;
    line.device.world_from_handle = sample.world_from_tool;
    recording.tape.push_back(line);
  }
  recording.events.insert(recording.events.begin(), simulator::CutEvent{});
}

void finish(Recording& recording) {
  recording.events.push_back({recording.samples.back().tick, CutEventKind::Finished, -1, 0, {}});
}

std::pair<Recording, Recording> whole_attempts() {
  std::pair<Recording, Recording> made{block_recording({testing::Stroke{}}),
                                       testing::akin_recording({}, testing::oval_bone())};
  for (Recording* each : {&made.first, &made.second}) {
    tell_all(*each);
    finish(*each);
  }
  return made;
}

TEST(BadRecording, NothingAtAll) { expect_sound_on_both({}, {}); }

TEST(BadRecording, EventsWithoutSamples) {
  auto [of_block, of_akin] = whole_attempts();
  of_block.samples.clear();
  of_akin.samples.clear();
  of_akin.tape.clear();
  expect_sound_on_both(of_block, of_akin);
}

TEST(BadRecording, OneSample) {
  auto [of_block, of_akin] = whole_attempts();
  for (Recording* each : {&of_block, &of_akin}) {
    each->samples.resize(1);
    each->tape.resize(1);
    each->events.resize(2);
  }
  expect_sound_on_both(of_block, of_akin);
  of_block.events.clear();
  of_akin.events.clear();
  expect_sound_on_both(of_block, of_akin);
}

TEST(BadRecording, NoCut) {
  auto [of_block, of_akin] = whole_attempts();
  for (Recording* each : {&of_block, &of_akin}) {
    std::erase_if(each->events,
                  [](const auto& event) { return event.kind == CutEventKind::PlaneFrozen; });
    for (simulator::ToolSample& sample : each->samples) {
      sample.kerf = -1;
      sample.status = bit(ToolStatus::Running) | bit(ToolStatus::SawOn);
    }
  }
  expect_sound_on_both(of_block, of_akin);
}

TEST(BadRecording, CutOffInMidStroke) {
  for (const double share : {0.01, 0.3, 0.7}) {
    auto [of_block, of_akin] = whole_attempts();
    for (Recording* each : {&of_block, &of_akin}) {
      const auto kept = static_cast<std::size_t>(share * static_cast<double>(each->samples.size()));
      each->samples.resize(kept);
      each->tape.resize(kept);
      const std::int64_t last_tick = each->samples.back().tick;
      std::erase_if(each->events, [&](const auto& event) { return event.tick > last_tick; });
    }
    const ExaminedAttempt made =
        examined(everything_counts(testing::akin_with_deeds()), testing::oval_bone(), of_akin);
    EXPECT_EQ(made.found("time_s").absence, Absence::NotDone);
    expect_sound_on_both(of_block, of_akin);
  }
}

TEST(BadRecording, TheSawWasNeverOn) {
  auto [of_block, of_akin] = whole_attempts();
  for (Recording* each : {&of_block, &of_akin}) {
    for (simulator::ToolSample& sample : each->samples) {
      sample.status &= ~(bit(ToolStatus::SawOn) | bit(ToolStatus::Cutting));
      sample.status |= bit(ToolStatus::InContact);
    }
  }
  const ExaminedAttempt made =
      examined(everything_counts(testing::block_scenario()), testing::block_bone(), of_block);
  EXPECT_EQ(made.found("irrigated_share").absence, Absence::NotMade);
  EXPECT_EQ(made.found("planning_s").absence, Absence::NotMade);
  expect_sound_on_both(of_block, of_akin);
}

TEST(BadRecording, TheTapeIsMissing) {
  auto [of_block, of_akin] = whole_attempts();
  of_block.tape.clear();
  of_akin.tape.clear();
  const ExaminedAttempt made =
      examined(everything_counts(testing::akin_with_deeds()), testing::oval_bone(), of_akin);
  for (const char* metric : {"sparc", "ldlj", "idle_s", "path_ratio"})
    EXPECT_EQ(made.found(metric).absence, Absence::NotRecorded) << metric;
  EXPECT_TRUE(made.found("time_s").is_measured());
  expect_sound_on_both(of_block, of_akin);
}

TEST(BadRecording, AnEngineThatKnewNoZones) {
  auto [of_block, of_akin] = whole_attempts();
  of_block.engine = of_akin.engine = 1;
  const ExaminedAttempt made =
      examined(everything_counts(testing::akin_with_deeds()), testing::oval_bone(), of_akin);
  EXPECT_EQ(made.found("joint_margin_mm").absence, Absence::Undefined);
  for (const char* metric : {"danger_contacts_count", "danger_s", "danger_depth_mm"})
    EXPECT_EQ(made.value(metric), 0.0) << metric;
  expect_sound_on_both(of_block, of_akin);
}

// A handle that goes on to the bit as evenly as it can has no jerk to take a logarithm of.
TEST(BadRecording, AHandleThatGlidesAsNoHandCan) {
  auto [of_block, of_akin] = whole_attempts();
  for (Recording* each : {&of_block, &of_akin}) {
    for (int part = 0; part < 3; ++part) {
      for (int step = 0; step < 1000; ++step) {
        simulator::ToolSample sample;
        sample.tick = each->samples.back().tick + (step == 0 ? 10 : 1);
        sample.status = bit(ToolStatus::Running);
        sample.world_from_tool.translation_um = {64 * step, 0, 0};
        each->samples.push_back(sample);
        simulator::TapeLine line;
        line.tick = sample.tick;
        line.device.world_from_handle = sample.world_from_tool;
        each->tape.push_back(line);
      }
    }
  }
  expect_sound_on_both(of_block, of_akin);
}

TEST(BadRecording, AnAttemptThatBeganAndRestedOnly) {
  Recording recording;
  for (std::int64_t tick = 0; tick < 3000; ++tick) {
    simulator::ToolSample sample;
    sample.tick = tick;
    recording.samples.push_back(sample);
  }
  tell_all(recording);
  finish(recording);
  expect_sound_on_both(recording, recording);
}

}  // namespace
}  // namespace hallux::assessment
