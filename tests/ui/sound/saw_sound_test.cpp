#include "ui/sound/saw_sound.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "simulator/base/units.h"

namespace hallux::ui {
namespace {

using Samples = std::vector<std::int16_t>;

Samples sound_of(const SawTone& tone, double seconds, SawSound& sound) {
  Samples samples(static_cast<std::size_t>(seconds * sound_rate_hz));
  sound.fill(tone, samples);
  return samples;
}

/// The sound once it has settled: half a second, after half a second.
Samples settled(const SawTone& tone, std::uint64_t seed = 5) {
  SawSound sound(seed);
  sound_of(tone, 0.5, sound);
  return sound_of(tone, 0.5, sound);
}

/// How much of a frequency is in it: Goertzel's sum, over all of it.
double strength(const Samples& samples, double hz) {
  const double step_rad = 2.0 * pi * hz / sound_rate_hz;
  double real = 0.0, imaginary = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    real += samples[i] * std::cos(step_rad * static_cast<double>(i));
    imaginary += samples[i] * std::sin(step_rad * static_cast<double>(i));
  }
  return std::hypot(real, imaginary) / static_cast<double>(samples.size());
}

/// The strongest frequency of a saw, to 1 Hz.
double strongest_hz(const Samples& samples) {
  double best_hz = 0.0, most = 0.0;
  for (double hz = 60.0; hz <= 500.0; hz += 1.0) {
    if (const double here = strength(samples, hz); here > most) {
      most = here;
      best_hz = hz;
    }
  }
  return best_hz;
}

double loudness(const Samples& samples) {
  double sum = 0.0;
  for (const std::int16_t sample : samples) sum += static_cast<double>(sample) * sample;
  return std::sqrt(sum / static_cast<double>(samples.size()));
}

TEST(SawSound, HasTheRateOfTheSawAsItsPitch) {
  for (const double cycles_per_minute : {6000.0, 12000.0, 18000.0}) {
    const SawTone tone{.runs = true, .saw = {.cycles_per_minute = cycles_per_minute}};
    EXPECT_NEAR(strongest_hz(settled(tone)), cycles_per_minute / 60.0, 1.0);
  }
}

TEST(SawSound, FallsByAFifthUnderFullLoad) {
  EXPECT_NEAR(strongest_hz(settled({.runs = true, .load = 1.0})), 160.0, 1.0);
  EXPECT_NEAR(strongest_hz(settled({.runs = true, .load = 0.5})), 180.0, 1.0);
}

TEST(SawSound, GrowsLouderWithTheLoad) {
  double last = 0.0;
  for (const double load : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    const double now = loudness(settled({.runs = true, .load = load}));
    EXPECT_GT(now, 1.2 * last);
    last = now;
  }
}

TEST(SawSound, HissesInBoneAndHumsInAir) {
  // Between its partials a saw in air is silent.
  const Samples in_air = settled({.runs = true}), in_bone = settled({.runs = true, .load = 1.0});
  double air = 0.0, bone = 0.0;
  for (double hz = 3010.0; hz < 3100.0; hz += 2.0) {
    air += strength(in_air, hz);
    bone += strength(in_bone, hz);
  }
  EXPECT_GT(bone, 10.0 * air);
}

TEST(SawSound, OfASawThatIsOffIsSilence) {
  for (const std::int16_t sample : settled({.runs = false, .load = 1.0})) ASSERT_EQ(sample, 0);
}

TEST(SawSound, FadesWhenTheSawStops) {
  SawSound sound(5);
  sound_of({.runs = true, .load = 1.0}, 0.5, sound);
  sound_of({.runs = false}, 0.5, sound);
  for (const std::int16_t sample : sound_of({.runs = false}, 0.1, sound)) ASSERT_EQ(sample, 0);
}

TEST(SawSound, OfOneLongBufferIsThatOfManyShortOnes) {
  const SawTone tone{.runs = true, .load = 0.4};
  SawSound whole(9), parts(9);
  const Samples at_once = sound_of(tone, 0.2, whole);
  Samples joined;
  for (std::size_t size = 1; joined.size() < at_once.size(); size = size % 700 + 37) {
    Samples part(std::min(size, at_once.size() - joined.size()));
    parts.fill(tone, part);
    joined.insert(joined.end(), part.begin(), part.end());
  }
  EXPECT_EQ(joined, at_once);
}

/// The steepest way of five partials of the highest rate, with the hiss: 2 pi f / 44100 times each
/// weight and number.
TEST(SawSound, MakesNoStepWhereTheToneChanges) {
  SawSound sound(5);
  Samples all;
  for (int i = 0; i < 60; ++i) {
    const SawTone tone{.runs = i % 7 != 0,
                       .saw = {.cycles_per_minute = i % 2 == 0 ? 5000.0 : 20000.0},
                       .load = 0.0};
    const Samples part = sound_of(tone, 0.02, sound);
    all.insert(all.end(), part.begin(), part.end());
  }
  const double slope = 2.0 * pi * (20000.0 / 60.0) / sound_rate_hz *
                       (0.40 + 2.0 * 0.22 + 3.0 * 0.12 + 4.0 * 0.07 + 5.0 * 0.04);
  const double steepest = 32767.0 * 0.25 * slope + 32767.0 * 0.25 / (0.03 * sound_rate_hz) + 1.0;
  for (std::size_t i = 1; i < all.size(); ++i) {
    ASSERT_LE(std::abs(all[i] - all[i - 1]), steepest) << i;
  }
}

RC_GTEST_PROP(SawSound, NeverClips, ()) {
  SawSound sound(*rc::gen::arbitrary<std::uint64_t>());
  Samples samples(200);
  for (int i = 0; i < 20; ++i) {
    SawTone tone;
    tone.runs = *rc::gen::inRange(0, 4) > 0;
    tone.saw.cycles_per_minute = *rc::gen::inRange(1000, 30000);
    tone.load = *rc::gen::inRange(-100, 300) * 0.01;
    sound.fill(tone, samples);
    for (const std::int16_t sample : samples) RC_ASSERT(std::abs(sample) <= 26214);  // 0.8
  }
}

simulator::ToolSample sawing(std::int32_t push_mn) {
  simulator::ToolSample sample;
  sample.status = static_cast<std::uint32_t>(simulator::ToolStatus::Running) |
                  static_cast<std::uint32_t>(simulator::ToolStatus::SawOn);
  sample.force_mn = {0, push_mn, 0};
  return sample;
}

TEST(SawTone, OfASawInAirHasNoLoad) {
  const SawTone tone = saw_tone(sawing(9000), {}, {.cycles_per_minute = 14000.0});
  EXPECT_TRUE(tone.runs);
  EXPECT_EQ(tone.load, 0.0);
  EXPECT_EQ(tone.saw.cycles_per_minute, 14000.0);
}

TEST(SawTone, IsFullAtTwentyNewtonInHardBoneAndHalfOfThatInSpongy) {
  EXPECT_NEAR(saw_tone(sawing(10000), {8.0, 0.0}, {.cycles_per_minute = 12000.0}).load, 0.5, 1e-12);
  EXPECT_NEAR(saw_tone(sawing(10000), {0.0, 8.0}, {.cycles_per_minute = 12000.0}).load, 0.25,
              1e-12);
  EXPECT_EQ(saw_tone(sawing(30000), {8.0, 0.0}, {.cycles_per_minute = 12000.0}).load, 1.0);
}

TEST(SawTone, OfAPausedAttemptIsNone) {
  simulator::ToolSample sample = sawing(10000);
  sample.status = static_cast<std::uint32_t>(simulator::ToolStatus::SawOn);
  EXPECT_FALSE(saw_tone(sample, {8.0, 0.0}, {.cycles_per_minute = 12000.0}).runs);
}

}  // namespace
}  // namespace hallux::ui
