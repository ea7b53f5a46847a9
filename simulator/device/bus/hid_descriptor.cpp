#include "simulator/device/bus/hid_descriptor.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

// Items by tag and type, their size left out.
constexpr std::uint8_t input = 0x80, collection = 0xA0;
constexpr std::uint8_t usage_page = 0x04, logical_maximum = 0x24;
constexpr std::uint8_t usage = 0x08, usage_maximum = 0x28;
constexpr std::uint8_t long_item = 0xFE;
constexpr std::uint16_t generic_desktop = 0x01, axis_x = 0x30, axis_rz = 0x35;

struct Item {
  std::uint8_t tag = 0;
  std::uint32_t bits = 0;
  std::size_t data_bytes = 0;

  /// As a number with a sign.
  std::int32_t number() const noexcept {
    if (data_bytes == 1) return static_cast<std::int8_t>(bits);
    if (data_bytes == 2) return static_cast<std::int16_t>(bits);
    return static_cast<std::int32_t>(bits);
  }
};

/// Calls `each` with every item.
template <typename Each>
void read_items(std::span<const std::uint8_t> bytes, Each&& each) noexcept {
  while (!bytes.empty()) {
    const std::uint8_t head = bytes[0];
    if (head == long_item) {
      const std::size_t size = bytes.size() < 2 ? bytes.size() : 3U + bytes[1];
      bytes = bytes.subspan(std::min(size, bytes.size()));
      continue;
    }
    Item item{static_cast<std::uint8_t>(head & 0xFCU), 0, (head & 3U) == 3U ? 4U : head & 3U};
    if (bytes.size() < 1 + item.data_bytes) return;
    for (std::size_t i = 0; i < item.data_bytes; ++i) {
      item.bits |= static_cast<std::uint32_t>(bytes[1 + i]) << (8U * i);
    }
    each(item);
    bytes = bytes.subspan(1 + item.data_bytes);
  }
}

bool is_axis(std::uint32_t value) noexcept { return value >= axis_x && value <= axis_rz; }

}  // namespace

std::optional<std::int32_t> axis_limit_in(std::span<const std::uint8_t> descriptor) noexcept {
  std::uint16_t page = 0;
  std::int32_t limit = 0;
  bool has_axis = false;
  std::optional<std::int32_t> least;
  read_items(descriptor, [&](const Item& item) {
    if (item.tag == usage_page) page = static_cast<std::uint16_t>(item.bits);
    if (item.tag == logical_maximum) limit = item.number();
    if (item.tag == usage || item.tag == usage_maximum)
      has_axis = has_axis || (page == generic_desktop && is_axis(item.bits));
    if (item.tag == input && has_axis && limit > 0) least = std::min(least.value_or(limit), limit);
    // A usage speaks of the next part only.
    if (item.tag == input || item.tag == collection) has_axis = false;
  });
  return least;
}

}  // namespace hallux::simulator
