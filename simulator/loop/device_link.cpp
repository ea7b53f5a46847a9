#include "simulator/loop/device_link.h"

#include <algorithm>

#include "simulator/base/units.h"
#include "simulator/record/sample_force.h"

namespace hallux::simulator {

namespace {

/// A force is made at the end of a line and carried by the exchange of the next.
constexpr std::int32_t exchanges_until_sent = 1;
/// A weaker simulated force has no direction that a surface could be told from.
constexpr double least_touch_newton = 0.05;

/// Nobody's attempt depends on it: it is never recorded.
constexpr std::uint64_t vibration_seed = 1;

/// 1 where the device has room for the strongest cycle, 0 where it renders none.
double vibration_scale_on(const DeviceDescription& device) {
  if (!device.limits || !device.limits->renders_vibration) return 0.0;
  const double strongest_newton = vibration_full_newton * (1.0 + vibration_noise);
  return std::min(1.0, vibration_share_of_force * device.limits->force_newton / strongest_newton);
}

std::optional<ForceOutputSettings> settings_for(const DeviceDescription& device,
                                                double contact_newton_per_mm) {
  if (!device.limits) return std::nullopt;
  return force_output_settings(*device.limits, device.motion_scale * contact_newton_per_mm,
                               exchanges_until_sent);
}

}  // namespace

DeviceLink::DeviceLink(HapticDevice& device, const SimulationSetup& simulated, ForceLaw law)
    : device_(device),
      motion_scale_(device.description().motion_scale),
      tray_(simulated.tray),
      bone_quality_(simulated.contact.bone_quality),
      law_(law),
      vibration_scale_(vibration_scale_on(device.description())),
      vibration_(vibration_seed),
      settings_(settings_for(device.description(), simulated.contact.coupling_newton_per_mm)),
      watchdog_(device.description().pulse) {}

DeviceState DeviceLink::read(std::int64_t last_tick, std::int64_t ticks) noexcept {
  last_tick_ = last_tick;
  RawDeviceState raw;
  const bool came = device_.exchange(force_.force_in_world_newton, last_tick, raw);
  if (came && raw.is_handed_over && !is_handed_over_) be_handed_over();
  return watchdog_.judge(came, raw, ticks);
}

/// Whoever leads now pushes nobody back.
void DeviceLink::be_handed_over() noexcept {
  is_handed_over_ = true;
  settings_.reset();
  vibration_scale_ = 0.0;
  watchdog_.expect(DevicePulse{});
}

void DeviceLink::set_force(const StepOutput& output, std::int64_t ticks) noexcept {
  const ToolSample& sample = output.sample;
  const Vec3 simulated_newton = simulator::force_newton(sample);
  if (!settings_) {
    force_ = {simulated_newton, 0};
    return;
  }
  const bool is_live =
      has(sample.status, ToolStatus::Running) && !has(sample.status, ToolStatus::Faulted);
  if (!is_live) thesis_law_ = {};
  // A guide leads in air too, and a kick outlasts its touch: they are no surface.
  const bool is_touching = has(sample.status, ToolStatus::InContact);
  const Vec3 felt_newton = law_ == ForceLaw::Thesis
                               ? thesis_law_newton(simulated_newton, is_touching, ticks)
                               : simulated_newton;
  const double duration_s = static_cast<double>(ticks) * step_s;
  const double push_newton = length_of(simulated_newton);
  force_ = output_force(
      output_, *settings_,
      {felt_newton, handle_in_hand_mm(), vibration_newton(output, push_newton, duration_s, is_live),
       duration_s, is_live});
}

Vec3 DeviceLink::vibration_newton(const StepOutput& output, double push_newton, double duration_s,
                                  bool is_live) noexcept {
  const Saw* const saw = tray_.saw(output.tool);
  if (!(vibration_scale_ > 0.0) || saw == nullptr) return {0.0, 0.0, 0.0};
  const ToolSample& sample = output.sample;
  VibrationInput input;
  input.saw_runs = is_live && has(sample.status, ToolStatus::SawOn);
  input.cycles_per_minute = saw->cycles_per_minute;
  input.duration_s = duration_s;
  if (has(sample.status, ToolStatus::Cutting)) {
    input.cutting_watt =
        cutting_watt(output.engaged, saw->blade.kerf_mm,
                     feed_rate_mm_s(output.engaged, push_newton, *saw, bone_quality_));
  }
  const Vec3 along_teeth = axis_y(transform_from(sample.world_from_tool));
  return vibration_scale_ * vibrate(vibration_, input) * along_teeth;
}

Vec3 DeviceLink::thesis_law_newton(const Vec3& simulated_newton, bool is_touching,
                                   std::int64_t ticks) noexcept {
  const double touch_newton = length_of(simulated_newton);
  std::optional<Vec3> normal;
  if (is_touching && touch_newton > least_touch_newton) normal = simulated_newton / touch_newton;
  const ThesisLawSettings settings{.force_limit_newton = settings_->force_newton};
  return thesis_law_force(thesis_law_, settings, handle_in_hand_mm(), normal, ticks) /
         settings_->scale;
}

void DeviceLink::release() noexcept {
  if (!settings_) return;
  force_ = output_force(output_, *settings_, {.is_live = false});
  RawDeviceState ignored;
  device_.exchange(force_.force_in_world_newton, last_tick_, ignored);
}

}  // namespace hallux::simulator
