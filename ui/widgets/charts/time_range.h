/// The part of a timeline that is shown: nearer, farther, moved. Plain functions; all of them stay
/// inside [0, duration]. Inside this corner only.
#pragma once

namespace hallux::ui {

struct TimeRange {
  double begin_s = 0.0, end_s = 1.0;

  double span_s() const noexcept { return end_s - begin_s; }
  bool contains(double time_s) const noexcept { return time_s >= begin_s && time_s <= end_s; }
  friend bool operator==(const TimeRange&, const TimeRange&) = default;
};

/// Nobody sees more in less: 200 samples.
inline constexpr double least_span_s = 0.2;

bool is_whole(const TimeRange& range, double duration_s) noexcept;

/// `factor` above 1 is nearer; what lies at `about_s` stays where it is, as far as the ends allow.
TimeRange zoomed(const TimeRange& range, double duration_s, double factor, double about_s) noexcept;
TimeRange moved(const TimeRange& range, double duration_s, double by_s) noexcept;
/// From the first to the last moment, with room at both sides.
TimeRange around(double first_s, double last_s, double duration_s) noexcept;
/// Moved to where the moment is in sight; as it is where it is already.
TimeRange showing(const TimeRange& range, double duration_s, double time_s) noexcept;

}  // namespace hallux::ui
