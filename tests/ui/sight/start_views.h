/// Where the shipped operations are first seen from, as a search found it (search_start_views).
#pragma once

#include <string_view>

#include "simulator/base/units.h"
#include "ui/sight/view_judge.h"

namespace hallux::ui {

inline StartView start_view_of(std::string_view scenario) {
  const auto view = [](double azimuth_deg, double elevation_deg, double roll_deg,
                       double radius_mm) {
    return StartView{radian_from_degree(azimuth_deg), radian_from_degree(elevation_deg),
                     radian_from_degree(roll_deg), radius_mm};
  };
  return scenario == "silver" ? view(-60.0, 65.0, 150.0, 35.0) : view(-60.0, 20.0, 0.0, 32.0);
}

/// Where the saw is held at first: so far off the bone, against the feed of the first stroke.
inline constexpr double stand_off_mm = 12.0;
inline RigidTransform start_of(const ViewJudge& judge) {
  RigidTransform start = judge.moments().front().world_from_tool;
  start.translation_mm -= stand_off_mm * (start.rotation * Vec3(1.0, 0.0, 0.0));
  return start;
}

}  // namespace hallux::ui
