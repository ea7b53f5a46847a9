/// The sound of a saw: its true rate as the pitch, which falls under load while it grows louder and
/// rougher. Inside this corner only.
///
/// Five partials of the rate and a little noise, summed with weights of at most 1, so that it never
/// clips. Rate and loudness go to what is asked for by the sample: however the buffers are cut, no
/// step is heard.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "simulator/base/random.h"
#include "simulator/contact/feed.h"
#include "simulator/record/record.h"
#include "simulator/tool/saw.h"

namespace hallux::ui {

inline constexpr int sound_rate_hz = 44100;

struct SawTone {
  bool runs = false;
  simulator::Saw saw = {};
  /// 0 in air, 1 where it is pushed as hard as it takes.
  double load = 0.0;
};

/// What the saw does at this moment of an attempt.
SawTone saw_tone(const simulator::ToolSample& sample, const simulator::Engagement& engaged,
                 const simulator::Saw& saw) noexcept;

/// The fundamental of a saw that has settled [Hz].
double saw_pitch_hz(const SawTone& tone) noexcept;
/// Its greatest value when settled, of 1.
double saw_loudness(const SawTone& tone) noexcept;

class SawSound {
 public:
  explicit SawSound(std::uint64_t seed) noexcept;

  /// The next samples, going towards the tone.
  void fill(const SawTone& tone, std::span<std::int16_t> samples) noexcept;

 private:
  double next() noexcept;

  double turns_ = 0.0;
  double pitch_hz_ = 0.0, loudness_ = 0.0, roughness_ = 0.0;
  /// Noise, made duller.
  double hiss_ = 0.0;
  Random noise_;
};

}  // namespace hallux::ui
