/// Channels to modelled devices, without a bus.
#pragma once

#include <algorithm>

#include "simulator/device/bus/hid_channel.h"
#include "simulator/device/bus/usb_channel.h"
#include "tests/support/served_bus/falcon_model.h"
#include "tests/support/served_bus/hid_models.h"

namespace hallux::tests {

class PlayedUsb final : public simulator::UsbChannel {
 public:
  /// Borrowed; `is_gone` says when it is pulled out.
  PlayedUsb(FalconModel& model, const bool& is_gone) : model_(model), is_gone_(is_gone) {}

  simulator::BusAnswer request(std::uint8_t number, std::uint16_t value) noexcept override {
    if (is_gone_) return simulator::BusAnswer::Gone;
    return model_.request(number, value) ? simulator::BusAnswer::Done
                                         : simulator::BusAnswer::Refused;
  }
  simulator::BusAnswer write(std::span<const std::uint8_t> bytes) noexcept override {
    if (is_gone_) return simulator::BusAnswer::Gone;
    model_.receive(bytes);
    return simulator::BusAnswer::Done;
  }
  simulator::BusRead read(std::span<std::uint8_t, simulator::usb_packet_bytes> packet,
                          std::chrono::milliseconds) noexcept override {
    if (is_gone_) return {simulator::BusAnswer::Gone, 0};
    if (!model_.has_news()) return {simulator::BusAnswer::Nothing, 0};
    const std::vector<std::uint8_t> bytes = model_.packet();
    std::copy(bytes.begin(), bytes.end(), packet.begin());
    return {simulator::BusAnswer::Done, bytes.size()};
  }

 private:
  FalconModel& model_;
  const bool& is_gone_;
};

class PlayedHid final : public simulator::HidChannel {
 public:
  PlayedHid(HidModel& model, const bool& is_gone) : model_(model), is_gone_(is_gone) {}

  simulator::BusAnswer write(std::span<const std::uint8_t> report) noexcept override {
    if (is_gone_) return simulator::BusAnswer::Gone;
    return model_.receive(report) ? simulator::BusAnswer::Done : simulator::BusAnswer::Refused;
  }
  simulator::BusRead read(std::span<std::uint8_t> report,
                          std::chrono::milliseconds) noexcept override {
    if (is_gone_) return {simulator::BusAnswer::Gone, 0};
    if (!model_.has_news()) return {simulator::BusAnswer::Nothing, 0};
    const std::vector<std::uint8_t> bytes = model_.take();
    const std::size_t count = std::min(bytes.size(), report.size());
    std::copy_n(bytes.begin(), count, report.begin());
    return {simulator::BusAnswer::Done, count};
  }

 private:
  HidModel& model_;
  const bool& is_gone_;
};

}  // namespace hallux::tests
