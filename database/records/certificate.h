/// Quality certificate of a recording, and whether it may be graded.
///
/// What falsifies a measurement makes it not valid: samples lost, made up or doubled, time that
/// nobody saw, a device that did not say where the hand was. Being late does not: a tick that comes
/// late, or two in one line, says where the tool was.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "database/records/names.h"

namespace hallux::database {

/// Times of the wall clock are those of a live attempt; a scripted one has none.
struct RecordingCertificate {
  /// Steps that the loop took.
  std::int64_t expected_samples = 0;
  /// Of them in the record.
  std::int64_t received_samples = 0;
  /// Places where the tape leaves ticks out.
  std::int64_t gaps = 0;
  /// Lines of the tape for ticks that another covers.
  std::int64_t duplicates = 0;
  /// That came in one line with the next.
  std::int64_t missed_ticks = 0;
  /// By the loop: more than three ticks late, or no room.
  std::int64_t pauses = 0;
  /// That the hand moved in such pauses; a full disk's not counted.
  std::int64_t unsampled_us = 0;
  /// Times the loop's clock stood still or jumped.
  std::int64_t clock_steps = 0;
  /// That the device said nothing of, or nothing to be trusted.
  std::int64_t faulted_ticks = 0;
  /// Mouse and keys have taken over from the device that it began with.
  bool has_changed_device = false;
  double late_p50_us = 0.0, late_p99_us = 0.0, late_max_us = 0.0;
  /// Of the fullest ring towards the recorder [0, 1].
  double ring_share_max = 0.0;
  /// The system ran the loop before all else.
  bool has_priority = false;
  bool has_locked_memory = false;

  bool is_complete() const noexcept { return expected_samples == received_samples; }
};

/// Why an attempt may not be graded.
enum class Invalidity {
  /// What the loop made is not all there: path, force and the bone itself are not known.
  SamplesLost,
  /// The tape has a gap: the step cannot be computed again over it.
  TicksLeftOut,
  /// Two lines for one tick: which one cut is not known.
  TicksDoubled,
  /// The machine slept: the hand had time that no tick counts.
  ClockStepped,
  /// Too much time in pauses of the loop: duration, speed and path are too short.
  TimeUnseen,
  /// So few samples a second that a tremor falls between them.
  TicksMissed,
  /// Where the hand was is not known for too long.
  DeviceFaulted,
  /// Two devices led the saw: it is comparable with neither.
  DeviceChanged
};

/// Beyond any of them an attempt is not valid for grading. Lost, left out and doubled rows and
/// steps of the clock have no limit: one is too many, and a sound recorder makes none.
/// source  docs/data_format.md, "Whether an attempt may be graded"
namespace certificate_limits {
/// Of the duration: the share by which it is wrong at most, below the narrowest band that time and
/// path are scored by.
inline constexpr double unsampled_share_max = 0.05;
/// Of the ticks: at a quarter, 750 samples a second are left, and a tremor of 12 Hz has 60 for each
/// swing.
inline constexpr double missed_share_max = 0.25;
/// Of the ticks: the force is off for as long, and the pose is the last one known.
inline constexpr double faulted_share_max = 0.01;
}  // namespace certificate_limits

struct Verdict {
  /// In the order of the enumerators; none: valid.
  std::vector<Invalidity> reasons;
  bool is_valid() const noexcept { return reasons.empty(); }
};

/// Judges by the limits above, nothing else.
Verdict verdict_of(const RecordingCertificate& certificate);

template <>
inline constexpr std::array<std::string_view, 8> stored_names<Invalidity>{
    "samples_lost", "ticks_left_out", "ticks_doubled",  "clock_stepped",
    "time_unseen",  "ticks_missed",   "device_faulted", "device_changed"};

}  // namespace hallux::database
