#include "ui/jobs/recording_quality.h"

#include <array>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "database/recording/certificate_json.h"
#include "simulator/device/force_output.h"
#include "ui/jobs/optional_json.h"

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

/// Certificates of before it was told have none.
std::optional<double> number_if_any(const nlohmann::json& json, const char* name) {
  const auto found = json.find(name);
  if (found == json.end() || found->is_null()) return std::nullopt;
  return found->get<double>();
}

nlohmann::ordered_json json_of(const simulator::DeviceFacts& device) {
  const simulator::PortFigures& figures = device.figures;
  return {{"kind", device.kind},
          {"model", device.model},
          {"class", device.device_class},
          {"library", device.library},
          {"motion_scale", device.motion_scale},
          {"own_force_scale", or_null(figures.own_force_scale)},
          {"calibration_age_s", or_null(figures.calibration_age_s)},
          {"packets", figures.packets},
          {"late_packets", figures.late_packets},
          {"bad_packets", figures.bad_packets},
          {"greatest_force_newton", figures.greatest_force_newton},
          {"round_trip_us",
           {{"p50", figures.round_trip_p50_us},
            {"p99", figures.round_trip_p99_us},
            {"max", figures.round_trip_max_us}}}};
}

/// errors  nlohmann::json::exception
simulator::DeviceFacts device_from(const nlohmann::json& json) {
  simulator::DeviceFacts device;
  json.at("kind").get_to(device.kind);
  json.at("model").get_to(device.model);
  json.at("class").get_to(device.device_class);
  json.at("library").get_to(device.library);
  json.at("motion_scale").get_to(device.motion_scale);
  simulator::PortFigures& figures = device.figures;
  figures.calibration_age_s = number_if_any(json, "calibration_age_s");
  figures.own_force_scale = number_if_any(json, "own_force_scale");
  json.at("packets").get_to(figures.packets);
  json.at("late_packets").get_to(figures.late_packets);
  json.at("bad_packets").get_to(figures.bad_packets);
  json.at("greatest_force_newton").get_to(figures.greatest_force_newton);
  const nlohmann::json& round_trip = json.at("round_trip_us");
  round_trip.at("p50").get_to(figures.round_trip_p50_us);
  round_trip.at("p99").get_to(figures.round_trip_p99_us);
  round_trip.at("max").get_to(figures.round_trip_max_us);
  return device;
}

}  // namespace

Quality quality_of(const simulator::LoopStatistics& loop,
                   const database::RecorderStatistics& recorder) {
  Quality quality;
  database::RecordingCertificate& certificate = quality.certificate;
  certificate.expected_samples = loop.lines;
  certificate.received_samples = recorder.samples;
  certificate.gaps = recorder.gaps;
  certificate.duplicates = recorder.duplicates;
  certificate.missed_ticks = loop.missed_ticks;
  certificate.pauses = loop.pauses;
  certificate.unsampled_us = loop.unsampled_us;
  certificate.clock_steps = loop.clock_steps;
  certificate.faulted_ticks = loop.faulted_ticks;
  certificate.has_changed_device = loop.has_changed_device;
  certificate.late_p50_us = loop.late_p50_us;
  certificate.late_p99_us = loop.late_p99_us;
  certificate.late_max_us = loop.late_max_us;
  certificate.ring_share_max = loop.ring_share_max;
  certificate.has_priority = loop.has_priority;
  certificate.has_locked_memory = loop.has_locked_memory;
  quality.force_scale = loop.force_scale;
  quality.force_limits = loop.force_limits;
  quality.force_law = loop.force_law;
  return quality;
}

const char* name_of(simulator::ForceLaw law) noexcept {
  return law == simulator::ForceLaw::Thesis ? "historic" : "simulated";
}

std::optional<simulator::ForceLaw> force_law_from(const std::string& name) noexcept {
  for (const auto law : {simulator::ForceLaw::Simulated, simulator::ForceLaw::Thesis}) {
    if (name == name_of(law)) return law;
  }
  return std::nullopt;
}

std::string quality_json(const Quality& quality) {
  auto json = nlohmann::ordered_json::parse(database::json_from_certificate(quality.certificate));
  json["force_scale"] = quality.force_scale;
  json["force_limits"] = names_of_limits(quality.force_limits);
  json["force_law"] = name_of(quality.force_law);
  if (quality.device) json["device"] = json_of(*quality.device);
  if (!quality.second_device.empty()) json["second_device"] = quality.second_device;
  return json.dump();
}

std::optional<Quality> quality_from_json(const std::string& json) {
  const auto certificate = database::certificate_from_json(json);
  if (!certificate) return std::nullopt;
  const nlohmann::json found = nlohmann::json::parse(json, nullptr, false);
  try {
    Quality quality{*certificate};
    quality.force_scale = found.value("force_scale", quality.force_scale);
    quality.force_limits =
        limits_from_names(found.value("force_limits", std::vector<std::string>{}));
    const auto law = force_law_from(found.value("force_law", name_of(quality.force_law)));
    if (!law) return std::nullopt;
    quality.force_law = *law;
    quality.second_device = found.value("second_device", quality.second_device);
    if (found.contains("device")) quality.device = device_from(found["device"]);
    return quality;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // a number where a word was expected: no object of ours
  }
}

}  // namespace hallux::ui
