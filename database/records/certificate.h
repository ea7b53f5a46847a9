/// How well an attempt was recorded, and whether what was recorded may be graded.
///
/// What falsifies a measurement makes it not valid: samples lost, made up or doubled, time that nobody saw, a device that did
/// not say where the hand was. Being late does not: a tick that comes late, or two in one line, says where the tool was.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace hallux::database {

/// Times of the wall clock are those of a live attempt; a scripted one has none.
struct RecordingCertificate {
  std::int64_t expected_samples = 0;  ///< steps that the loop took
  std::int64_t received_samples = 0;  ///< of them in the record
  std::int64_t gaps = 0;              ///< places where the tape leaves ticks out
  std::int64_t duplicates = 0;        ///< lines of the tape for ticks that another covers
  std::int64_t missed_ticks = 0;      ///< that came in one line with the next
  std::int64_t pauses = 0;            ///< by the loop: more than three ticks late, or no room
  std::int64_t unseen_us = 0;    ///< that the hand moved in such pauses; a full disk's not counted
  std::int64_t clock_steps = 0;  ///< times the loop's clock stood still or jumped
  std::int64_t faulted_ticks = 0;  ///< that the device said nothing of, or nothing to be trusted
  double late_p50_us = 0.0, late_p99_us = 0.0, late_max_us = 0.0;
  double ring_share_max = 0.0;  ///< of the fullest ring towards the recorder [0, 1]
  bool has_priority = false;    ///< the system ran the loop before all else
  bool has_locked_memory = false;

  bool is_complete() const noexcept { return expected_samples == received_samples; }
};

/// Why an attempt may not be graded.
enum class Invalidity {
  SamplesLost,  ///< what the loop made is not all there: path, force and the bone itself are not known
  TicksLeftOut,  ///< the tape has a gap: the step cannot be computed again over it
  TicksDoubled,  ///< two lines for one tick: which one cut is not known
  ClockStepped,  ///< the machine slept: the hand had time that no tick counts
  TimeUnseen,    ///< too much time in pauses of the loop: duration, speed and path are too short
  TicksMissed,   ///< so few samples a second that a tremor falls between them
  DeviceFaulted  ///< where the hand was is not known for too long
};

/// Beyond any of them an attempt is not valid for grading. Lost, left out and doubled rows and steps of the clock have no
/// limit: one is too many, and a sound recorder makes none.
/// source  docs/data_format.md, "Whether an attempt may be graded"
namespace certificate_limits {
/// Of the duration: the share by which it is wrong at most, below the narrowest band that time and path are scored by.
inline constexpr double unseen_share_max = 0.05;
/// Of the ticks: at a quarter, 750 samples a second are left, and a tremor of 12 Hz has 60 for each swing.
inline constexpr double missed_share_max = 0.25;
/// Of the ticks: the force is off for as long, and the pose is the last one known.
inline constexpr double faulted_share_max = 0.01;
}  // namespace certificate_limits

struct Verdict {
  std::vector<Invalidity> reasons;  ///< in the order of the enumerators; none: valid
  bool is_valid() const noexcept { return reasons.empty(); }
};

/// Judges by the limits above, nothing else.
Verdict verdict_of(const RecordingCertificate& certificate);

inline constexpr std::array<Invalidity, 7> invalidities{
    Invalidity::SamplesLost,  Invalidity::TicksLeftOut, Invalidity::TicksDoubled,
    Invalidity::ClockStepped, Invalidity::TimeUnseen,   Invalidity::TicksMissed,
    Invalidity::DeviceFaulted};

/// The word in JSON: "samples_lost", "ticks_left_out", "ticks_doubled", "clock_stepped", "time_unseen", "ticks_missed",
/// "device_faulted".
std::string_view name_of(Invalidity reason) noexcept;

}  // namespace hallux::database
