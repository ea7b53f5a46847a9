#include "ui/screens/operating/hud/operating_health.h"

#include <array>
#include <utility>

#include "simulator/device/force_output.h"

namespace hallux::ui {

namespace {

using simulator::ForceLimit;

constexpr double shown_for_s = 1.0;
/// Of the loop and of its rings, beyond which people are told.
constexpr double late_limit_us = 2000.0, ring_limit = 0.5;

constexpr std::array<std::pair<ForceLimit, std::string_view>, 7> limit_texts{{
    {ForceLimit::Stopped, "limit.stopped"},
    {ForceLimit::TooFast, "limit.too_fast"},
    {ForceLimit::Heat, "limit.heat"},
    {ForceLimit::Greatest, "limit.greatest"},
    {ForceLimit::Passivity, "limit.passivity"},
    {ForceLimit::SoftStart, "limit.soft_start"},
    {ForceLimit::Slew, "limit.slew"},
}};

}  // namespace

OperatingHealth health_of(const simulator::LoopView& view, std::optional<double> force_scale,
                          std::uint32_t recent_limits) {
  OperatingHealth health;
  health.late_us = view.late_us;
  health.missed_ticks = static_cast<long>(view.missed_ticks);
  health.pauses = static_cast<long>(view.pauses);
  health.ring_share = view.ring_share;
  health.has_priority = view.has_priority;
  health.has_locked_memory = view.has_locked_memory;
  if (force_scale)
    health.arm = ArmHealth{*force_scale, glm::length(view.device_force_newton), recent_limits};
  return health;
}

std::string_view trouble_of(const simulator::LoopView& view, bool has_lost_picture) noexcept {
  if (has(view.sample.status, simulator::ToolStatus::Faulted)) return "operate.trouble.device";
  if (has_lost_picture) return "operate.trouble.picture";
  if (view.ring_share > ring_limit) return "operate.trouble.disk";
  if (view.late_us <= late_limit_us) return {};
  return view.has_priority ? "operate.trouble.busy" : "operate.trouble.priority";
}

void RecentLimits::observe(std::uint32_t limits, double now_s) noexcept {
  if (now_s - since_s_ >= shown_for_s) {
    before_ = std::exchange(now_, 0);
    since_s_ = now_s;
  }
  now_ |= limits;
}

std::vector<std::string_view> limit_text_ids(std::uint32_t limits) {
  std::vector<std::string_view> words;
  for (const auto& [limit, id] : limit_texts) {
    if (has(limits, limit)) words.push_back(id);
  }
  return words;
}

}  // namespace hallux::ui
