#include "simulator/device/falcon/falcon_driver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulator/base/units.h"
#include "simulator/device/falcon/falcon_firmware.h"
#include "simulator/device/falcon/ftdi_line.h"

namespace hallux::simulator {

namespace {

using std::chrono::milliseconds;

/// How often each is tried.
constexpr int run_tries = 10, load_tries = 10, boot_tries = 20;
constexpr milliseconds run_answer{20}, boot_answer{100}, echo_answer{1000};
/// That fit into a packet of the bridge, beside its status.
constexpr std::size_t boot_chunk_bytes = usb_packet_bytes - ftdi_status_bytes;
/// Longer than a period of the bridge's clock, shorter than a dead man's patience.
constexpr milliseconds exchange_answer{3};
constexpr double mm_per_metre = 1000.0;

constexpr std::array<std::uint8_t, 3> boot_call{0x0A, 0x43, 0x0D};
constexpr std::array<std::uint8_t, 4> boot_reply{0x0A, 0x44, 0x2C, 0x0D};
constexpr std::array<std::uint8_t, 1> baud_call{0x41};

std::uint8_t light_for(bool is_homed) noexcept {
  return static_cast<std::uint8_t>(is_homed ? FalconLight::Blue : FalconLight::Red);
}

TroubleReport trouble_of(BusAnswer answer) {
  if (answer == BusAnswer::Gone) return {DeviceTrouble::Unplugged, {}, {}};
  return {DeviceTrouble::SystemRefused, {}, "the USB bridge refused a setting"};
}

}  // namespace

FalconDriver::FalconDriver(std::function<OpenedUsb()> open_channel, FalconSettings settings)
    : open_channel_(std::move(open_channel)), settings_(std::move(settings)) {
  state_.is_homed = false;
}

/// source  docs/haptics.md, Devices: figures of the open drivers; that of the continuous force is
///         ours
DeviceDescription FalconDriver::description() const {
  return {"Novint Falcon", "arm3",
          DeviceLimits{.force_newton = 6.0,
                       .continuous_force_newton = 4.0,
                       .thermal_time_s = 10.0,
                       .stiffness_newton_per_mm = 3.0,
                       .damping_newton_s_per_mm = 0.02,
                       .transport_ticks = 2,
                       .renders_vibration = true},
          DevicePulse{.numbers_packets = true}};
}

TroubleReport FalconDriver::open(const OpeningWatch& watch) {
  OpenedUsb opened = open_channel_();
  if (opened.trouble) return opened.trouble;
  channel_ = std::move(opened.channel);
  TroubleReport trouble = bring_up(watch);
  if (trouble) channel_.reset();
  return trouble;
}

TroubleReport FalconDriver::bring_up(const OpeningWatch& watch) {
  BusAnswer answer = start_running();
  if (answer == BusAnswer::Done) return {};
  if (answer != BusAnswer::Nothing) return trouble_of(answer);
  if (settings_.firmware.empty()) return {DeviceTrouble::NoFirmware, {}, {}};
  const FalconFirmware firmware = read_falcon_firmware(settings_.firmware);
  if (firmware.fault) {
    return {DeviceTrouble::BadFirmware, settings_.firmware.string(),
            "byte " + std::to_string(firmware.fault->byte) + ": " + firmware.fault->what};
  }
  bool is_stopped = false;
  const OpeningWatch stopping = [&](PortPhase phase, double fraction) {
    is_stopped = is_stopped || !watch(phase, fraction);
    return !is_stopped;
  };
  for (int tries = 0; tries < load_tries && stopping(PortPhase::Loading, 0.0); ++tries) {
    answer = load(firmware.image, stopping);
    if (answer == BusAnswer::Done) answer = start_running();
    if (answer == BusAnswer::Done) return {};
    if (answer == BusAnswer::Gone) return trouble_of(answer);
  }
  if (is_stopped) return {};
  return {DeviceTrouble::WrongEcho, settings_.firmware.string(), {}};
}

/// Nothing where no firmware answers.
BusAnswer FalconDriver::start_running() noexcept {
  const BusAnswer configured = configure(
      *channel_, {latency_run, baud_run, eight_bits, no_flow_control, purge_received, purge_sent});
  if (configured != BusAnswer::Done) return configured;
  reports_ = {};
  for (int tries = 0; tries < run_tries; ++tries) {
    const BusAnswer sent = send(*channel_, encoded({{}, light_for(false), true}));
    if (sent != BusAnswer::Done) return sent;
    FalconPacket packet{};
    const BusAnswer heard = receive(*channel_, packet, run_answer);
    if (heard == BusAnswer::Gone || heard == BusAnswer::Refused) return heard;
    if (heard == BusAnswer::Done && reports_.take(packet)) return BusAnswer::Done;
  }
  return BusAnswer::Nothing;
}

/// The terminal's line going high starts the boot loader, which answers its call.
BusAnswer FalconDriver::enter_boot_loader() noexcept {
  BusAnswer answer =
      configure(*channel_, {purge_received, purge_sent, latency_boot, baud_9600, eight_bits,
                            no_flow_control, ready_low, terminal_low, terminal_high});
  if (answer != BusAnswer::Done) return answer;
  std::array<std::uint8_t, boot_reply.size()> heard{};
  for (int tries = 0; tries < boot_tries; ++tries) {
    answer = send(*channel_, boot_call);
    if (answer != BusAnswer::Done) return answer;
    answer = receive(*channel_, heard, boot_answer);
    if (answer == BusAnswer::Gone || answer == BusAnswer::Refused) return answer;
    // Some say a zero first, or an answer to the call before.
    const bool is_reply = std::find(heard.begin(), heard.end(), boot_reply[1]) != heard.end();
    if (answer == BusAnswer::Done && is_reply) break;
  }
  answer = configure(*channel_, {terminal_low, baud_boot, purge_received});
  if (answer == BusAnswer::Done) answer = send(*channel_, baud_call);
  std::array<std::uint8_t, 1> echoed{};
  if (answer == BusAnswer::Done) answer = receive(*channel_, echoed, echo_answer);
  return answer == BusAnswer::Done && echoed != baud_call ? BusAnswer::Nothing : answer;
}

/// Nothing where something came back otherwise than it was sent: its only checksum.
BusAnswer FalconDriver::load(std::span<const std::uint8_t> image, const OpeningWatch& watch) {
  BusAnswer answer = enter_boot_loader();
  std::array<std::uint8_t, boot_chunk_bytes> echo{};
  for (std::size_t at = 0; answer == BusAnswer::Done && at < image.size();) {
    const std::span<const std::uint8_t> chunk =
        image.subspan(at, std::min(boot_chunk_bytes, image.size() - at));
    answer = send(*channel_, chunk);
    const std::span<std::uint8_t> heard = std::span(echo).first(chunk.size());
    if (answer == BusAnswer::Done) answer = receive(*channel_, heard, echo_answer);
    if (answer != BusAnswer::Done) return answer;
    if (!std::equal(chunk.begin(), chunk.end(), heard.begin())) return BusAnswer::Nothing;
    at += chunk.size();
    if (!watch(PortPhase::Loading, static_cast<double>(at) / static_cast<double>(image.size())))
      return BusAnswer::Nothing;
  }
  return answer;
}

DriverExchange FalconDriver::exchange(const Vec3& force_in_device_newton) noexcept {
  const auto answered = [&](DriverAnswer answer) {
    return DriverExchange{answer, state_, DeviceTrouble::None};
  };
  const DriverExchange gone{DriverAnswer::Gone, state_, DeviceTrouble::Unplugged};
  if (!channel_) return gone;
  const FalconCommand command{motors_for(force_in_device_newton), light_for(state_.is_homed), true};
  if (channel_->write(encoded(command)) == BusAnswer::Gone) return gone;
  const auto end = std::chrono::steady_clock::now() + exchange_answer;
  const std::uint64_t bad = reports_.bad();
  std::array<std::uint8_t, usb_packet_bytes> packet{};
  while (std::chrono::steady_clock::now() < end) {
    const BusRead read = channel_->read(packet, exchange_answer);
    if (read.answer == BusAnswer::Gone) return gone;
    if (read.answer != BusAnswer::Done) break;
    const auto report = reports_.take(ftdi_payload(std::span(packet).first(read.bytes)));
    if (report) return answered(take(*report) ? DriverAnswer::Said : DriverAnswer::Garbled);
  }
  return answered(reports_.bad() > bad ? DriverAnswer::Garbled : DriverAnswer::Nothing);
}

/// False where the legs cannot stand so.
bool FalconDriver::take(const FalconReport& report) noexcept {
  const CrankAngles angles = crank_angles_at(report.encoders);
  const bool was_homed = state_.is_homed;
  state_.is_homed = report.is_homed();
  state_.buttons = report.buttons;
  // The encoders' zero jumps where a leg comes home: from then on it is searched anew.
  if (was_homed != state_.is_homed) grip_mm_ = falcon_middle_mm;
  std::optional<Vec3> grip_mm = grip_place(angles, grip_mm_);
  if (!grip_mm) grip_mm = grip_place(angles, falcon_middle_mm);
  if (!grip_mm) return !state_.is_homed;
  grip_mm_ = *grip_mm;
  angles_ = angles;
  state_.device_from_handle.translation_mm = grip_mm_ - falcon_middle_mm;
  return true;
}

FalconCounts FalconDriver::motors_for(const Vec3& force_in_device_newton) const noexcept {
  FalconCounts counts{};
  if (!state_.is_homed || force_in_device_newton == Vec3(0.0, 0.0, 0.0)) return counts;
  const Vec3 torques_newton_mm =
      crank_torques(crank_rates(grip_mm_, angles_), force_in_device_newton);
  const Vec3 wanted = -settings_.counts_per_newton_metre / mm_per_metre * torques_newton_mm;
  const double greatest = std::max({std::abs(wanted.x), std::abs(wanted.y), std::abs(wanted.z)});
  const double share = greatest > falcon_motor_counts ? falcon_motor_counts / greatest : 1.0;
  for (std::size_t leg = 0; leg < falcon_legs; ++leg) {
    counts[leg] = round_to_int32(share * wanted[static_cast<glm::length_t>(leg)]);
  }
  return counts;
}

void FalconDriver::close() noexcept {
  if (!channel_) return;
  // Once more where the first is lost on its way.
  for (int tries = 0; tries < 2; ++tries) {
    if (send(*channel_, encoded({{}, light_for(false), true})) != BusAnswer::Done) break;
    FalconPacket answer{};
    if (receive(*channel_, answer, exchange_answer) == BusAnswer::Gone) break;
  }
  channel_.reset();
  state_.is_homed = false;
}

}  // namespace hallux::simulator
