#include "simulator/device/falcon/falcon_packet.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <string_view>
#include <vector>

namespace hallux::simulator {
namespace {

std::vector<std::uint8_t> bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

FalconReport report_of(std::string_view text) {
  const std::vector<std::uint8_t> bytes = bytes_of(text);
  return decoded(
             std::span<const std::uint8_t, falcon_packet_bytes>(bytes.data(), falcon_packet_bytes))
      .value();
}

TEST(FalconPacket, SaysMotorsLightsAndHoming) {
  const FalconPacket packet =
      encoded({{-1447, 0, 4095}, static_cast<std::uint8_t>(FalconLight::Blue), true});
  EXPECT_EQ(std::string_view(reinterpret_cast<const char*>(packet.data()), packet.size()),
            "<JFKPAAAAPPPAFA>");
}

TEST(FalconPacket, NeverSaysMoreThanTheMotorsTake) {
  EXPECT_EQ(encoded({{70'000, -70'000, 0}, 0, true}),
            encoded({{falcon_motor_counts, -falcon_motor_counts, 0}, 0, true}));
}

TEST(FalconPacket, TellsEncodersButtonsAndLegsThatAreHome) {
  // 0x7F: every leg, every button.
  const FalconReport report = report_of(
      "<JFKPAAAAPPPH\xC0"
      "A>");
  EXPECT_EQ(report.encoders, (FalconCounts{-1447, 0, 0x7FFF}));
  EXPECT_EQ(report.buttons, 0x0F);
  EXPECT_TRUE(report.is_homed());
  EXPECT_FALSE(report_of("<AAAAAAAAAAAAqA>").is_homed());
}

RC_GTEST_PROP(FalconPacket, WhateverIsSaidIsHeard, ()) {
  FalconCommand command;
  for (std::int32_t& motor : command.motors) {
    motor = *rc::gen::inRange(-falcon_motor_counts, falcon_motor_counts + 1);
  }
  // A command is a report that tells of no leg: both lie alike.
  const FalconPacket packet = encoded(command);
  RC_ASSERT(decoded(packet).value().encoders == command.motors);
}

TEST(FalconReports, FindsReportsHoweverTheyAreCut) {
  FalconReports reports;
  EXPECT_FALSE(reports.take(bytes_of("<AAAAAAA")));
  EXPECT_TRUE(reports.take(bytes_of("AAAAAAA><BAAAAAAA")));
  const std::optional<FalconReport> second = reports.take(bytes_of("AAAAAA>"));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->encoders[0], 1);
  EXPECT_EQ(reports.count(), 2U);
  EXPECT_EQ(reports.bad(), 0U);
}

TEST(FalconReports, OfSeveralTheNewestIsTold) {
  FalconReports reports;
  EXPECT_EQ(reports.take(bytes_of("<BAAAAAAAAAAAAA><CAAAAAAAAAAAAA>")).value().encoders[0], 2);
  EXPECT_EQ(reports.count(), 2U);
}

TEST(FalconReports, ARowOfBytesThatIsNoPacketCountsOnceAndHidesNone) {
  FalconReports reports;
  EXPECT_TRUE(reports.take(bytes_of("garbage<BAAAAAAAAAAAAA>")));
  EXPECT_EQ(reports.bad(), 1U);
  // A packet whose end was lost, and the next within it.
  EXPECT_TRUE(reports.take(bytes_of("<CAAAAAA<DAAAAAAAAAAAAA>")));
  EXPECT_EQ(reports.count(), 2U);
  EXPECT_EQ(reports.bad(), 2U);
}

TEST(FalconReports, AByteThatSaysNoNibbleMakesNoReport) {
  FalconReports reports;
  EXPECT_FALSE(reports.take(bytes_of("<AzAAAAAAAAAAAA>")));
  EXPECT_EQ(reports.bad(), 1U);
}

RC_GTEST_PROP(FalconReports, AnyBytesBeforeHideNoMoreThanTheNextReport, ()) {
  FalconReports reports;
  static_cast<void>(reports.take(*rc::gen::arbitrary<std::vector<std::uint8_t>>()));
  static_cast<void>(reports.take(bytes_of("<BAAAAAAAAAAAAA>")));
  const std::optional<FalconReport> report = reports.take(bytes_of("<BAAAAAAAAAAAAA>"));
  RC_ASSERT(report && report->encoders[0] == 1);
}

}  // namespace
}  // namespace hallux::simulator
