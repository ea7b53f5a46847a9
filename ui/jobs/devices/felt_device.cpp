#include "ui/jobs/devices/felt_device.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include "ui/jobs/devices/felt_wall.h"

namespace hallux::ui {

namespace {

constexpr std::chrono::milliseconds tick{1};
/// As stiff as people call a wall, where the device renders it.
constexpr double wall_newton_per_mm = 1.0, share_of_stiffness = 0.5;

}  // namespace

void Reach::add(const Vec3& grip_mm) noexcept {
  least_mm = is_known ? glm::min(least_mm, grip_mm) : grip_mm;
  greatest_mm = is_known ? glm::max(greatest_mm, grip_mm) : grip_mm;
  is_known = true;
}

FeltDevice::FeltDevice(std::shared_ptr<simulator::Station> station, simulator::FoundDevice device,
                       double force_share)
    : station_(std::move(station)),
      device_(std::move(device)),
      force_share_(force_share),
      port_(station_->open(device_.id)) {
  if (port_) thread_ = std::jthread([this](const std::stop_token& stop) { run(stop); });
}

FeltDevice::~FeltDevice() {
  if (thread_.joinable()) {
    thread_.request_stop();
    thread_.join();
  }
  station_->close(device_.id);
}

simulator::TroubleReport FeltDevice::trouble() const {
  if (!port_) return {simulator::DeviceTrouble::Unplugged, device_.address, {}};
  return port_->trouble();
}

/// Nothing said is no force: the port lets go by itself.
void FeltDevice::run(const std::stop_token& stop) noexcept {
  std::optional<FeltWall> wall;
  std::optional<simulator::DeviceLimits> limits;
  FeltState felt;
  for (auto next = std::chrono::steady_clock::now(); !stop.stop_requested(); next += tick) {
    const simulator::PortState& state = port_->newest();
    const bool has_begun =
        state.phase == simulator::PortPhase::Running && felt.phase != state.phase;
    if (has_begun) limits = limits_at_share(port_->description().limits, force_share_);
    felt.phase = state.phase;
    felt.fraction = state.fraction;
    felt.said = state.said;
    felt.has_motors = limits.has_value();
    const Vec3& grip_mm = state.said.device_from_handle.translation_mm;
    if (forgets_reach_.exchange(false, std::memory_order_relaxed)) felt.reach = {};
    if (state.phase == simulator::PortPhase::Running) felt.reach.add(grip_mm);
    const bool is_held = is_wall_wanted() && limits && state.said.buttons != 0 &&
                         state.phase == simulator::PortPhase::Running;
    if (is_held && !wall) {
      wall.emplace(
          *limits,
          std::min(wall_newton_per_mm, share_of_stiffness * limits->stiffness_newton_per_mm),
          grip_mm);
    }
    if (!is_held) wall.reset();
    if (wall) port_->say(wall->force_newton(grip_mm));
    felt.is_pushing = wall.has_value();
    state_.write(felt);
    std::this_thread::sleep_until(next);
  }
}

}  // namespace hallux::ui
