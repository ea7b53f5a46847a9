#include "simulator/device/space_mouse/space_mouse_driver.h"

#include <algorithm>
#include <utility>

namespace hallux::simulator {

namespace {

constexpr std::uint16_t logitech = 0x046D, connexion = 0x256F;
/// Made for Logitech, whose number also stands on every other thing it makes.
constexpr std::array<std::uint16_t, 12> of_logitech{0xC603, 0xC605, 0xC606, 0xC621, 0xC623, 0xC625,
                                                    0xC626, 0xC627, 0xC628, 0xC629, 0xC62B, 0xC640};
/// Two-dimensional mice, keyboards and receivers of 3Dconnexion.
constexpr std::array<std::uint16_t, 12> others{0xC62C, 0xC641, 0xC650, 0xC651, 0xC654, 0xC655,
                                               0xC656, 0xC657, 0xC658, 0xC664, 0xC665, 0xC668};

constexpr std::chrono::milliseconds report_within{8};
constexpr int reports_at_once = 64;
/// Longer than any that we know.
constexpr std::size_t report_bytes_most = 64;

template <std::size_t Count>
bool holds(const std::array<std::uint16_t, Count>& all, std::uint16_t wanted) noexcept {
  return std::find(all.begin(), all.end(), wanted) != all.end();
}

}  // namespace

bool is_space_mouse(std::uint16_t vendor, std::uint16_t product, const HidUsage& usage) noexcept {
  if (usage != multi_axis_controller) return false;
  return (vendor == logitech && holds(of_logitech, product)) ||
         (vendor == connexion && !holds(others, product));
}

SpaceMouseDriver::SpaceMouseDriver(std::function<OpenedHid()> open_channel, std::string name,
                                   std::int32_t axis_limit)
    : open_channel_(std::move(open_channel)), name_(std::move(name)), axis_limit_(axis_limit) {}

/// It speaks only while its cap is moved.
DeviceDescription SpaceMouseDriver::description() const { return {name_, "rate"}; }

TroubleReport SpaceMouseDriver::open(const OpeningWatch&) {
  OpenedHid opened = open_channel_();
  if (opened.trouble) return opened.trouble;
  channel_ = std::move(opened.channel);
  // One without a light refuses; that harms nobody.
  static_cast<void>(channel_->write(space_mouse_light_on));
  return {};
}

DriverExchange SpaceMouseDriver::exchange(const Vec3&) noexcept {
  DriverExchange exchange;
  if (!channel_) return {DriverAnswer::Gone, state_, DeviceTrouble::Unplugged};
  std::array<std::uint8_t, report_bytes_most> bytes{};
  BusRead read = channel_->read(bytes, report_within);
  // To the newest of those that wait.
  for (int i = 0; i < reports_at_once && read.answer == BusAnswer::Done; ++i) {
    const SpaceMouseNews news = take_report(said_, std::span(bytes).first(read.bytes));
    if (news == SpaceMouseNews::Garbled && exchange.answer == DriverAnswer::Nothing)
      exchange.answer = DriverAnswer::Garbled;
    if (news == SpaceMouseNews::Motion || news == SpaceMouseNews::Buttons)
      exchange.answer = DriverAnswer::Said;
    read = channel_->read(bytes, std::chrono::milliseconds{0});
  }
  if (read.answer == BusAnswer::Gone) return {DriverAnswer::Gone, state_, DeviceTrouble::Unplugged};
  state_.deflection = deflection_of(said_, axis_limit_);
  state_.buttons = said_.buttons;
  exchange.state = state_;
  return exchange;
}

void SpaceMouseDriver::close() noexcept {
  if (!channel_) return;
  static_cast<void>(channel_->write(space_mouse_light_off));
  channel_.reset();
}

}  // namespace hallux::simulator
