// A view is compared with the last that was kept and not with the one of the last frame, so that a
// slow turn is kept, too; and where it comes to rest is kept with the frames that follow.
#include "ui/jobs/noted_views.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::ui {

namespace {

using simulator::ShownView;

constexpr double moved_on_screen_mm = 2.0, magnified_by = 0.01, aspect_by = 0.01;
constexpr double turned_rad = radian_from_degree(0.4);

bool is_ratio_other(double a, double b, double by) noexcept {
  return std::abs(a - b) > by * std::min(a, b);
}

}  // namespace

bool is_noticeably_other(const ShownView& a, const ShownView& b) noexcept {
  if (a.stereo != b.stereo || a.layout != b.layout) return true;
  const double magnification = std::max(a.magnification, b.magnification);
  const double turned_cosine = std::abs(glm::dot(a.world_from_view, b.world_from_view));
  return turned_cosine < std::cos(0.5 * turned_rad) ||
         glm::length(a.target_in_world_mm - b.target_in_world_mm) * magnification >
             moved_on_screen_mm ||
         std::abs(a.target_depth_mm - b.target_depth_mm) * magnification > moved_on_screen_mm ||
         is_ratio_other(a.magnification, b.magnification, magnified_by) ||
         is_ratio_other(a.width_over_height, b.width_over_height, aspect_by);
}

void NotedViews::note(const ShownView& view, std::int64_t tick) noexcept {
  if (kept_ && (tick < kept_tick_ + ticks_between || !is_noticeably_other(view, *kept_))) return;
  std::optional<simulator::DisplayFact> fact = fact_of(view, tick);
  if (!fact) return;
  fact->lost_before = lost_;
  kept_ = view;
  kept_tick_ = tick;
  lost_ = ring_.push(*fact) ? 0 : lost_ + 1;
}

}  // namespace hallux::ui
