#include "simulator/device/falcon/ftdi_line.h"

namespace hallux::simulator {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds sent_within{1000};

}  // namespace

BusAnswer configure(UsbChannel& channel, std::initializer_list<FtdiSetting> settings) noexcept {
  for (const FtdiSetting& each : settings) {
    const BusAnswer answer = channel.request(each.request, each.value);
    if (answer != BusAnswer::Done) return answer;
  }
  return BusAnswer::Done;
}

BusAnswer send(UsbChannel& channel, std::span<const std::uint8_t> bytes) noexcept {
  const auto end = Clock::now() + sent_within;
  BusAnswer answer = channel.write(bytes);
  while (answer == BusAnswer::Nothing && Clock::now() < end) answer = channel.write(bytes);
  return answer;
}

BusAnswer receive(UsbChannel& channel, std::span<std::uint8_t> bytes,
                  std::chrono::milliseconds wait) noexcept {
  const auto end = Clock::now() + wait;
  std::array<std::uint8_t, usb_packet_bytes> packet{};
  std::size_t count = 0;
  while (count < bytes.size()) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
    if (left.count() <= 0) return BusAnswer::Nothing;
    const BusRead read = channel.read(packet, left);
    if (read.answer == BusAnswer::Nothing) continue;
    if (read.answer != BusAnswer::Done) return read.answer;
    const auto payload = ftdi_payload(std::span(packet).first(read.bytes));
    const std::size_t taken = std::min(payload.size(), bytes.size() - count);
    std::copy_n(payload.begin(), taken, bytes.begin() + static_cast<std::ptrdiff_t>(count));
    count += taken;
  }
  return BusAnswer::Done;
}

}  // namespace hallux::simulator
