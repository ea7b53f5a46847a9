#include "ui/sound/saw_sound.h"

#include <algorithm>
#include <cmath>

#include "simulator/record/sample_force.h"

namespace hallux::ui {

namespace {

using simulator::ToolStatus;

/// A push at which the load is full: the upper end of what operators use.
constexpr double full_push_newton = 20.0;
/// Spongy bone loads a saw half as much as hard bone does.
constexpr double spongy_share = 0.5;
constexpr double pitch_drop = 0.2;
constexpr double free_loudness = 0.25, full_loudness = 0.8;
/// A saw at rest starts its way up from here.
constexpr double least_pitch_hz = 40.0;
/// Partials, with the hiss at its roughest: their sum is 1.
constexpr std::array<double, 5> partials{0.40, 0.22, 0.12, 0.07, 0.04};
constexpr double most_hiss = 0.15;
constexpr double spin_s = 0.06, fade_s = 0.03, roughen_s = 0.03;
constexpr double hiss_keeps = 0.6;

double approached(double value, double wanted, double time_constant_s) noexcept {
  return value + (wanted - value) / (time_constant_s * sound_rate_hz);
}

}  // namespace

SawTone saw_tone(const simulator::ToolSample& sample, const simulator::Engagement& engaged,
                 const simulator::Saw& saw) noexcept {
  SawTone tone{.saw = saw};
  tone.runs = has(sample.status, ToolStatus::Running) && has(sample.status, ToolStatus::SawOn);
  if (!(engaged.width_mm() > 0.0)) return tone;
  const double hardness =
      (engaged.cortical_mm + spongy_share * engaged.cancellous_mm) / engaged.width_mm();
  tone.load =
      std::clamp(hardness * simulator::force_size_newton(sample) / full_push_newton, 0.0, 1.0);
  return tone;
}

double saw_pitch_hz(const SawTone& tone) noexcept {
  return tone.saw.cycles_per_minute / 60.0 * (1.0 - pitch_drop * std::clamp(tone.load, 0.0, 1.0));
}

double saw_loudness(const SawTone& tone) noexcept {
  if (!tone.runs) return 0.0;
  return free_loudness + (full_loudness - free_loudness) * std::clamp(tone.load, 0.0, 1.0);
}

SawSound::SawSound(std::uint64_t seed) noexcept : noise_(seed, "saw") {}

void SawSound::fill(const SawTone& tone, std::span<std::int16_t> samples) noexcept {
  const double pitch_hz = tone.runs ? saw_pitch_hz(tone) : least_pitch_hz;
  const double loudness = saw_loudness(tone);
  const double roughness = tone.runs ? std::clamp(tone.load, 0.0, 1.0) : 0.0;
  pitch_hz_ = std::max(pitch_hz_, least_pitch_hz);
  for (std::int16_t& sample : samples) {
    pitch_hz_ = approached(pitch_hz_, pitch_hz, spin_s);
    loudness_ = approached(loudness_, loudness, fade_s);
    roughness_ = approached(roughness_, roughness, roughen_s);
    sample = static_cast<std::int16_t>(std::lround(32767.0 * loudness_ * next()));
  }
}

/// Within -1 and 1.
double SawSound::next() noexcept {
  turns_ += pitch_hz_ / sound_rate_hz;
  turns_ -= std::floor(turns_);
  double sum = 0.0;
  for (std::size_t i = 0; i < partials.size(); ++i) {
    sum += partials[i] * std::sin(2.0 * pi * static_cast<double>(i + 1) * turns_);
  }
  hiss_ = hiss_keeps * hiss_ + (1.0 - hiss_keeps) * noise_.uniform(-1.0, 1.0);
  return sum + most_hiss * roughness_ * hiss_;
}

}  // namespace hallux::ui
