#include "database/records/certificate.h"

#include <gtest/gtest.h>

#include "database/recording/certificate_json.h"

namespace hallux::database {

namespace {

/// A minute at a desk where all went well.
RecordingCertificate sound() {
  RecordingCertificate certificate;
  certificate.expected_samples = certificate.received_samples = 60'000;
  return certificate;
}

std::vector<Invalidity> reasons_after(void (*harm)(RecordingCertificate&)) {
  RecordingCertificate certificate = sound();
  harm(certificate);
  return verdict_of(certificate).reasons;
}

using Reasons = std::vector<Invalidity>;

TEST(Certificate, OfASoundRecordingIsValid) {
  EXPECT_TRUE(verdict_of(sound()).is_valid());
  EXPECT_TRUE(verdict_of({}).is_valid()) << "nothing happened, and all of it is there";
}

TEST(Certificate, OneRowLostLeftOutOrDoubledIsTooMany) {
  EXPECT_EQ(reasons_after([](auto& c) { c.received_samples -= 1; }),
            Reasons{Invalidity::SamplesLost});
  EXPECT_EQ(reasons_after([](auto& c) { c.received_samples += 1; }),
            Reasons{Invalidity::SamplesLost});
  EXPECT_EQ(reasons_after([](auto& c) { c.gaps = 1; }), Reasons{Invalidity::TicksLeftOut});
  EXPECT_EQ(reasons_after([](auto& c) { c.duplicates = 1; }), Reasons{Invalidity::TicksDoubled});
  EXPECT_EQ(reasons_after([](auto& c) { c.clock_steps = 1; }), Reasons{Invalidity::ClockStepped});
}

TEST(Certificate, HasALimitForWhatIsOnlyTooMuchOf) {
  // A twentieth of a minute unseen is allowed, a microsecond more is not; so with the others.
  EXPECT_EQ(reasons_after([](auto& c) { c.unsampled_us = 3'000'000; }), Reasons{});
  EXPECT_EQ(reasons_after([](auto& c) { c.unsampled_us = 3'000'001; }),
            Reasons{Invalidity::TimeUnseen});
  EXPECT_EQ(reasons_after([](auto& c) { c.missed_ticks = 20'000; }), Reasons{});
  EXPECT_EQ(reasons_after([](auto& c) { c.missed_ticks = 20'001; }),
            Reasons{Invalidity::TicksMissed});
  EXPECT_EQ(reasons_after([](auto& c) { c.faulted_ticks = 600; }), Reasons{});
  EXPECT_EQ(reasons_after([](auto& c) { c.faulted_ticks = 601; }),
            Reasons{Invalidity::DeviceFaulted});
}

TEST(Certificate, OfTwoDevicesIsComparableWithNeither) {
  EXPECT_EQ(reasons_after([](auto& c) { c.has_changed_device = true; }),
            Reasons{Invalidity::DeviceChanged});
}

TEST(Certificate, IsNotSpoiltByBeingLate) {
  EXPECT_EQ(reasons_after([](auto& c) {
              c.late_p50_us = 900.0;
              c.late_p99_us = 2900.0;
              c.late_max_us = 2'000'000.0;
              c.pauses = 4000;
              c.ring_share_max = 0.99;
            }),
            Reasons{});
}

TEST(Certificate, NamesAllThatIsWrongInOrder) {
  const Reasons reasons = reasons_after([](auto& c) {
    c.received_samples = 0;
    c.gaps = c.duplicates = c.clock_steps = 1;
    c.unsampled_us = 60'000'000;
    c.missed_ticks = c.faulted_ticks = 60'000;
    c.has_changed_device = true;
  });
  Reasons all;
  for (std::size_t i = 0; i < stored_names<Invalidity>.size(); ++i) {
    all.push_back(static_cast<Invalidity>(i));
  }
  EXPECT_EQ(reasons, all);
}

TEST(Certificate, IsReadAsItWasWritten) {
  RecordingCertificate written = sound();
  written.gaps = 1;
  written.duplicates = 2;
  written.missed_ticks = 3;
  written.pauses = 4;
  written.unsampled_us = 5;
  written.clock_steps = 6;
  written.faulted_ticks = 7;
  written.has_changed_device = true;
  written.late_p50_us = 8.5;
  written.late_p99_us = 9.5;
  written.late_max_us = 10.5;
  written.ring_share_max = 0.25;
  written.has_priority = written.has_locked_memory = true;
  const std::string json = json_from_certificate(written);
  const auto read = certificate_from_json(json);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(json_from_certificate(*read), json);
  EXPECT_EQ(read->faulted_ticks, 7);
  EXPECT_TRUE(read->has_changed_device);
  EXPECT_FALSE(is_valid_by(json));
  EXPECT_NE(json.find(R"("ticks_doubled","clock_stepped","device_changed"])"), std::string::npos)
      << json;
}

TEST(Certificate, OfAnOlderProgramIsValidWhereItWasComplete) {
  const std::string older =
      R"({"expected_samples": 7, "received_samples": 7, "pauses": 2, "complete": true})";
  ASSERT_TRUE(certificate_from_json(older).has_value());
  EXPECT_EQ(certificate_from_json(older)->pauses, 2);
  EXPECT_TRUE(is_valid_by(older));
  EXPECT_FALSE(is_valid_by(R"({"complete": false})"));
  EXPECT_FALSE(is_valid_by(R"({"complete": true, "valid": false})"));
}

TEST(Certificate, IsNoneWhereTheTextIsNone) {
  for (const char* text : {"", "{}", "[]", "7", "no json", R"({"expected_samples": "many"})",
                           R"({"expected_samples": 1, "received_samples": 1, "gaps": "few"})"}) {
    EXPECT_FALSE(certificate_from_json(text).has_value()) << text;
    EXPECT_FALSE(is_valid_by(text)) << text;
  }
  EXPECT_FALSE(is_valid_by(R"({"valid": 1, "complete": true})"));
}

}  // namespace

}  // namespace hallux::database
