#include "simulator/device/raw_hid_arm/arm_packet.h"

#include <gtest/gtest.h>

namespace hallux::simulator {
namespace {

std::array<std::uint8_t, arm_report_bytes> report_of(const std::array<std::int16_t, 7>& words) {
  std::array<std::uint8_t, arm_report_bytes> bytes{};
  for (std::size_t i = 0; i < words.size(); ++i) {
    bytes[2 * i] = static_cast<std::uint8_t>(words[i] & 0xFF);
    bytes[2 * i + 1] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(words[i]) >> 8U);
  }
  return bytes;
}

TEST(ArmPacket, TellsCountsAndTheButtonOnTopOfOne) {
  const ArmCounts counts{100, -200, 300, -10, 20, 30};
  EXPECT_EQ(arm_report(report_of({100, -200, 300, -10, 20, 30, 7})), (ArmReport{counts, false}));
  EXPECT_EQ(arm_report(report_of({100, -200, 300, 9990, 20, 30, 7})), (ArmReport{counts, true}));
}

TEST(ArmPacket, AReportOfAnotherLengthIsNone) {
  const std::array<std::uint8_t, arm_report_bytes + 1> bytes{};
  EXPECT_FALSE(arm_report(std::span(bytes).first(14)));
  EXPECT_FALSE(arm_report(bytes));
  EXPECT_FALSE(arm_report({}));
}

TEST(ArmPacket, SaysCurrentsInMilliamperes) {
  const ArmOutput output = arm_currents({0.3, -2.0, 99.0});
  EXPECT_EQ(output[0], 0);
  const std::optional<ArmReport> words = arm_report(std::span(output).subspan(1));
  ASSERT_TRUE(words);
  EXPECT_EQ(words->counts, (ArmCounts{300, -2000, 32767, 0, 0, 0}));
}

TEST(ArmPacket, SetsEncodersWithoutACurrent) {
  const ArmOutput output = arm_encoders_set({1, 2, 6000, 4, 5, 6});
  const std::array<std::uint8_t, 14> expected{4, 0, 5, 0, 6, 0, 1, 0, 1, 0, 2, 0, 0x70, 0x17};
  EXPECT_TRUE(std::equal(expected.begin(), expected.end(), output.begin() + 1));
}

}  // namespace
}  // namespace hallux::simulator
