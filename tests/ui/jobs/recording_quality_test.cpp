#include "ui/jobs/recording_quality.h"

#include <gtest/gtest.h>

#include "simulator/device/force_output.h"

namespace hallux::ui {
namespace {

using simulator::ForceLimit;

TEST(RecordingQuality, IsReadAsItWasWritten) {
  simulator::LoopStatistics loop;
  loop.lines = 12'000;
  loop.missed_ticks = 3;
  loop.pauses = 2;
  loop.late_p99_us = 65.25;
  loop.has_priority = true;
  loop.force_scale = 0.24;
  database::RecorderStatistics recorder;
  recorder.samples = 11'999;
  Quality quality = quality_of(loop, recorder);
  for (const ForceLimit limit :
       {ForceLimit::Stopped, ForceLimit::TooFast, ForceLimit::SoftStart, ForceLimit::Passivity,
        ForceLimit::Heat, ForceLimit::Greatest, ForceLimit::Slew}) {
    quality.force_limits = bit(limit);
    const auto read = quality_from_json(quality_json(quality));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->force_limits, bit(limit));
  }
  const auto read = quality_from_json(quality_json(quality));
  EXPECT_EQ(read->certificate.expected_samples, 12'000);
  EXPECT_EQ(read->certificate.received_samples, 11'999);
  EXPECT_EQ(read->certificate.missed_ticks, 3);
  EXPECT_EQ(read->certificate.pauses, 2);
  EXPECT_DOUBLE_EQ(read->certificate.late_p99_us, 65.25);
  EXPECT_TRUE(read->certificate.has_priority);
  EXPECT_FALSE(read->certificate.has_locked_memory);
  EXPECT_DOUBLE_EQ(read->force_scale, 0.24);
  EXPECT_FALSE(read->certificate.is_complete());
}

TEST(RecordingQuality, TakesFromLoopAndRecorderWhatTheCertificateNames) {
  simulator::LoopStatistics loop;
  loop.lines = 10;
  loop.unsampled_us = 1;
  loop.clock_steps = 2;
  loop.faulted_ticks = 3;
  loop.ring_share_max = 0.5;
  loop.late_p50_us = 4.0;
  loop.late_max_us = 5.0;
  database::RecorderStatistics recorder;
  recorder.samples = 9;
  recorder.gaps = 6;
  recorder.duplicates = 7;
  const auto certificate = quality_of(loop, recorder).certificate;
  EXPECT_EQ(certificate.unsampled_us, 1);
  EXPECT_EQ(certificate.clock_steps, 2);
  EXPECT_EQ(certificate.faulted_ticks, 3);
  EXPECT_EQ(certificate.ring_share_max, 0.5);
  EXPECT_EQ(certificate.late_p50_us, 4.0);
  EXPECT_EQ(certificate.late_max_us, 5.0);
  EXPECT_EQ(certificate.gaps, 6);
  EXPECT_EQ(certificate.duplicates, 7);
  EXPECT_FALSE(verdict_of(certificate).is_valid());
}

TEST(RecordingQuality, OfAnOlderProgramSaysThatNobodyWasPushedBack) {
  const auto read = quality_from_json(R"({"expected_samples": 7, "received_samples": 7})");
  ASSERT_TRUE(read.has_value());
  EXPECT_TRUE(read->certificate.is_complete());
  EXPECT_DOUBLE_EQ(read->force_scale, 1.0);
  EXPECT_EQ(read->force_limits, 0U);
  EXPECT_EQ(read->force_law, simulator::ForceLaw::Simulated);
}

TEST(RecordingQuality, KeepsTheForceLawThatTheHandFelt) {
  for (const auto law : {simulator::ForceLaw::Simulated, simulator::ForceLaw::Thesis}) {
    simulator::LoopStatistics loop;
    loop.force_law = law;
    const auto read = quality_from_json(quality_json(quality_of(loop, {})));
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->force_law, law);
  }
}

TEST(RecordingQuality, LeavesOutALimitThatItDoesNotKnow) {
  const auto read = quality_from_json(
      R"({"expected_samples": 1, "received_samples": 1, "force_limits": ["heat", "mood"]})");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->force_limits, bit(ForceLimit::Heat));
}

TEST(RecordingQuality, IsUnknownWhereTheTextIsNone) {
  for (const char* text :
       {"", "{}", "[]", "7", "not json", R"({"expected_samples": "many", "received_samples": 1})",
        R"({"expected_samples": 1, "received_samples": 1, "force_limits": 3})",
        R"({"expected_samples": 1, "received_samples": 1, "force_law": "of nature"})"})
    EXPECT_FALSE(quality_from_json(text).has_value()) << text;
}

}  // namespace
}  // namespace hallux::ui
