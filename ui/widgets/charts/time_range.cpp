#include "ui/widgets/charts/time_range.h"

#include <algorithm>
#include <cmath>

namespace hallux::ui {

namespace {

/// Of the span, beside what is looked at.
constexpr double room_around = 0.15;

/// The span is kept within its bounds, then the whole inside the duration.
TimeRange placed(double begin_s, double span_s, double duration_s) noexcept {
  const double most_s = std::max(duration_s, 0.001);
  const double kept_s = std::clamp(span_s, std::min(least_span_s, most_s), most_s);
  const double first_s = std::clamp(begin_s, 0.0, most_s - kept_s);
  return {first_s, first_s + kept_s};
}

}  // namespace

bool is_whole(const TimeRange& range, double duration_s) noexcept {
  return range.span_s() >= duration_s * (1.0 - 1.0e-9);
}

TimeRange zoomed(const TimeRange& range, double duration_s, double factor,
                 double about_s) noexcept {
  const double span_s = range.span_s() / factor;
  const double kept_s = placed(0.0, span_s, duration_s).span_s();
  const double share = (about_s - range.begin_s) / range.span_s();
  return placed(about_s - share * kept_s, kept_s, duration_s);
}

TimeRange moved(const TimeRange& range, double duration_s, double by_s) noexcept {
  return placed(range.begin_s + by_s, range.span_s(), duration_s);
}

TimeRange around(double first_s, double last_s, double duration_s) noexcept {
  const double span_s = std::max(last_s - first_s, 0.0);
  const double wide_s = placed(0.0, span_s * (1.0 + 2.0 * room_around), duration_s).span_s();
  return placed(0.5 * (first_s + last_s) - 0.5 * wide_s, wide_s, duration_s);
}

TimeRange showing(const TimeRange& range, double duration_s, double time_s) noexcept {
  if (range.contains(time_s)) return range;
  const double room_s = room_around * range.span_s();
  // Played on it comes in at the left, stepped back at the right.
  const double begin_s = time_s > range.end_s ? time_s - room_s : time_s + room_s - range.span_s();
  return placed(begin_s, range.span_s(), duration_s);
}

}  // namespace hallux::ui
