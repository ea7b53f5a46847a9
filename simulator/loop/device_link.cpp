#include "simulator/loop/device_link.h"

#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// A force is made at the end of a tick and carried by the exchange of the next.
constexpr std::int32_t ticks_until_sent = 1;
/// A weaker simulated force has no direction that a surface could be told from.
constexpr double least_touch_newton = 0.05;

std::optional<ForceOutputSettings> settings_for(const DeviceDescription& device,
                                                double contact_newton_per_mm) {
  if (!device.limits) return std::nullopt;
  return force_output_settings(*device.limits, contact_newton_per_mm, ticks_until_sent);
}

}  // namespace

DeviceLink::DeviceLink(HapticDevice& device, double contact_newton_per_mm, ForceLaw law)
    : device_(device),
      law_(law),
      settings_(settings_for(device.description(), contact_newton_per_mm)),
      watchdog_(device.description().pulse) {}

DeviceState DeviceLink::read(std::int64_t last_tick, std::int64_t ticks) noexcept {
  last_tick_ = last_tick;
  RawDeviceState raw;
  const bool came = device_.exchange(force_.force_in_world_newton, last_tick, raw);
  return watchdog_.judge(came, raw, ticks);
}

void DeviceLink::give(const ToolSample& sample, std::int64_t ticks) noexcept {
  const Vec3 simulated_newton{newton_from_millinewton(sample.force_mn[0]),
                              newton_from_millinewton(sample.force_mn[1]),
                              newton_from_millinewton(sample.force_mn[2])};
  if (!settings_) {
    force_ = {simulated_newton, 0};
    return;
  }
  const bool is_live =
      has(sample.status, ToolStatus::Running) && !has(sample.status, ToolStatus::Faulted);
  if (!is_live) historic_ = {};
  const Vec3 felt_newton =
      law_ == ForceLaw::Historic ? historic_newton(simulated_newton, ticks) : simulated_newton;
  force_ = output_force(output_, *settings_,
                        {felt_newton, watchdog_.last_good().translation_mm,
                         static_cast<double>(ticks) * step_s, is_live});
}

Vec3 DeviceLink::historic_newton(const Vec3& simulated_newton, std::int64_t ticks) noexcept {
  const double touch_newton = std::sqrt(glm::dot(simulated_newton, simulated_newton));
  std::optional<Vec3> normal;
  if (touch_newton > least_touch_newton) normal = simulated_newton / touch_newton;
  const HistoricSettings settings{.force_limit_newton = settings_->force_newton};
  const Vec3 handle_mm = watchdog_.last_good().translation_mm;
  return historic_force(historic_, settings, handle_mm, normal, ticks) / settings_->scale;
}

void DeviceLink::let_go() noexcept {
  if (!settings_) return;
  force_ = output_force(output_, *settings_, {.is_live = false});
  RawDeviceState ignored;
  device_.exchange(force_.force_in_world_newton, last_tick_, ignored);
}

}  // namespace hallux::simulator
