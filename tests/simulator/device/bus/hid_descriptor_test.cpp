#include "simulator/device/bus/hid_descriptor.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace hallux::simulator {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// A multi-axis controller with axes to 350 in one report, to 500 in the other, and two buttons.
const Bytes controller{0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xA1, 0x00, 0x85, 0x01, 0x16, 0xA2,
                       0xFE, 0x26, 0x5E, 0x01, 0x09, 0x30, 0x09, 0x31, 0x09, 0x32, 0x75, 0x10,
                       0x95, 0x03, 0x81, 0x06, 0xC0, 0xA1, 0x00, 0x85, 0x02, 0x26, 0xF4, 0x01,
                       0x09, 0x33, 0x09, 0x34, 0x09, 0x35, 0x95, 0x03, 0x81, 0x06, 0xC0, 0xA1,
                       0x02, 0x85, 0x03, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x25, 0x01, 0x75,
                       0x01, 0x95, 0x02, 0x81, 0x02, 0xC0, 0xC0};

TEST(HidDescriptor, SaysWhatTheDeviceIsFor) {
  EXPECT_EQ(usage_in(controller), multi_axis_controller);
  const Bytes board{0x06, 0xAB, 0xFF, 0x0A, 0x00, 0x02, 0xA1, 0x01, 0xC0};
  EXPECT_EQ(usage_in(board), (HidUsage{0xFFAB, 0x0200}));
}

TEST(HidDescriptor, TheLeastReachOfItsAxesCounts) { EXPECT_EQ(axis_limit_in(controller), 350); }

TEST(HidDescriptor, ButtonsAreNoAxes) {
  EXPECT_FALSE(axis_limit_in(Bytes{0x05, 0x09, 0x19, 0x01, 0x29, 0x30, 0x25, 0x01, 0x81, 0x02}));
}

TEST(HidDescriptor, OneThatBreaksOffSaysWhatCameBefore) {
  EXPECT_FALSE(usage_in(Bytes{0x05, 0x01, 0x09}));
  EXPECT_FALSE(usage_in({}));
  EXPECT_EQ(axis_limit_in(std::span(controller).first(30)), 350);
  // A long item, and one that ends behind the bytes.
  EXPECT_FALSE(usage_in(Bytes{0xFE, 0xFF, 0x00, 0x01}));
  EXPECT_FALSE(usage_in(Bytes{0xFE}));
}

RC_GTEST_PROP(HidDescriptor, AnyBytesAreRead, (const Bytes& bytes)) {
  static_cast<void>(usage_in(bytes));
  const std::optional<std::int32_t> limit = axis_limit_in(bytes);
  RC_ASSERT(!limit || *limit > 0);
}

}  // namespace
}  // namespace hallux::simulator
