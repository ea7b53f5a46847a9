#include "ui/jobs/recording_quality.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "simulator/device/force_output.h"

namespace hallux::ui {

namespace {

using simulator::ForceLimit;

constexpr std::array<std::pair<ForceLimit, const char*>, 7> limit_names{{
    {ForceLimit::Stopped, "stopped"},
    {ForceLimit::TooFast, "too_fast"},
    {ForceLimit::SoftStart, "soft_start"},
    {ForceLimit::Passivity, "passivity"},
    {ForceLimit::Heat, "heat"},
    {ForceLimit::Greatest, "greatest"},
    {ForceLimit::Slew, "slew"},
}};

/// What kept the device's force from being scale x simulated.
std::vector<std::string> names_of_limits(std::uint32_t bits) {
  std::vector<std::string> found;
  for (const auto& [limit, name] : limit_names) {
    if (has(bits, limit)) found.emplace_back(name);
  }
  return found;
}

std::uint32_t limits_from_names(const std::vector<std::string>& found) {
  std::uint32_t bits = 0;
  for (const auto& [limit, name] : limit_names) {
    for (const std::string& each : found) {
      if (each == name) bits |= static_cast<std::uint32_t>(limit);
    }
  }
  return bits;
}

}  // namespace

Quality quality_of(const simulator::LoopStatistics& loop, std::int64_t received_samples) {
  return {loop.lines,        received_samples,  loop.missed_ticks,      loop.pauses,
          loop.late_p99_us,  loop.has_priority, loop.has_locked_memory, loop.force_scale,
          loop.force_limits, loop.force_law};
}

const char* name_of(simulator::ForceLaw law) noexcept {
  return law == simulator::ForceLaw::Historic ? "historic" : "simulated";
}

std::optional<simulator::ForceLaw> force_law_from(const std::string& name) noexcept {
  for (const auto law : {simulator::ForceLaw::Simulated, simulator::ForceLaw::Historic}) {
    if (name == name_of(law)) return law;
  }
  return std::nullopt;
}

std::string quality_json(const Quality& quality) {
  return nlohmann::ordered_json{{"expected_samples", quality.expected_samples},
                                {"received_samples", quality.received_samples},
                                {"missed_ticks", quality.missed_ticks},
                                {"pauses", quality.pauses},
                                {"late_p99_us", quality.late_p99_us},
                                {"priority", quality.has_priority},
                                {"locked_memory", quality.has_locked_memory},
                                {"force_scale", quality.force_scale},
                                {"force_limits", names_of_limits(quality.force_limits)},
                                {"force_law", name_of(quality.force_law)},
                                {"complete", quality.is_complete()}}
      .dump();
}

std::optional<Quality> quality_from_json(const std::string& json) {
  const nlohmann::json found = nlohmann::json::parse(json, nullptr, false);
  if (!found.is_object()) return std::nullopt;
  try {
    Quality quality;
    found.at("expected_samples").get_to(quality.expected_samples);
    found.at("received_samples").get_to(quality.received_samples);
    quality.missed_ticks = found.value("missed_ticks", quality.missed_ticks);
    quality.pauses = found.value("pauses", quality.pauses);
    quality.late_p99_us = found.value("late_p99_us", quality.late_p99_us);
    quality.has_priority = found.value("priority", quality.has_priority);
    quality.has_locked_memory = found.value("locked_memory", quality.has_locked_memory);
    quality.force_scale = found.value("force_scale", quality.force_scale);
    quality.force_limits =
        limits_from_names(found.value("force_limits", std::vector<std::string>{}));
    const auto law = force_law_from(found.value("force_law", name_of(quality.force_law)));
    if (!law) return std::nullopt;
    quality.force_law = *law;
    return quality;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // a number where a word was expected: no object of ours
  }
}

}  // namespace hallux::ui
