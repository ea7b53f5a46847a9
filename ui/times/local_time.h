/// Moments as the clock of this machine's time zone says them. What is kept, exported and written
/// as JSON or CSV stays UTC; people read local times.
///
/// The zone is the C library's: /etc/localtime, or the variable TZ, which tests set
/// (tests/support/time_zone.h).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace hallux::ui {

struct LocalTime {
  int year = 0, month = 1, day = 1, hour = 0, minute = 0;
  /// How far the clock is before UTC at that moment, in minutes.
  int offset_min = 0;
  friend bool operator==(const LocalTime&, const LocalTime&) = default;
};

/// Nothing for what is no ISO 8601 moment in UTC (seconds and what is smaller may be missing).
/// thread  any
std::optional<LocalTime> local_time(std::string_view utc) noexcept;

/// "+01:00"
std::string offset_text(int offset_min);

/// "3 Mar 2026, 14:02"; what is no moment is said as it is.
std::string moment_text(std::string_view utc);
/// "3 Mar 2026, 14:02 +01:00", where it stands alone or is asked for.
std::string full_moment_text(std::string_view utc);
/// "3 Mar 2026"
std::string date_text(std::string_view utc);

/// Whole days of the local calendar from one moment to another; 0 where either is none.
int days_between(std::string_view earlier_utc, std::string_view later_utc) noexcept;

}  // namespace hallux::ui
