#include "simulator/record/display_fact.h"

#include <algorithm>
#include <cmath>

#include "simulator/base/units.h"

namespace hallux::simulator {

namespace {

/// A day: no operation takes longer.
constexpr std::int64_t tick_max = 86'400'000;
/// A room: what is looked at lies inside.
constexpr std::int64_t length_max_um = 100'000'000;
constexpr std::int64_t magnification_max_milli = 1'000'000;
constexpr std::int64_t aspect_min_milli = 50, aspect_max_milli = 50'000;
constexpr std::int64_t lost_max = 1'000'000'000;
/// A rounded unit quaternion; a length that far from 1 is no rotation.
constexpr std::int64_t part_max_micro = 1'500'000;
constexpr std::int64_t square_min = 500'000'000'000, square_max = 2'000'000'000'000;

bool is_within(std::int64_t value, std::int64_t low, std::int64_t high) noexcept {
  return value >= low && value <= high;
}

std::int64_t milli_from_ratio(double ratio) noexcept { return round_to_int32(ratio * 1000.0); }
double ratio_from_milli(std::int64_t milli) noexcept { return static_cast<double>(milli) / 1000.0; }

bool is_finite(const ShownView& view) noexcept {
  const Vec3& target = view.target_in_world_mm;
  const Quat& turn = view.world_from_view;
  const std::array<double, 10> parts{target.x,
                                     target.y,
                                     target.z,
                                     turn.w,
                                     turn.x,
                                     turn.y,
                                     turn.z,
                                     view.magnification,
                                     view.target_depth_mm,
                                     view.width_over_height};
  return std::ranges::all_of(parts, [](double part) { return std::isfinite(part); });
}

bool is_rotation(const std::array<std::int64_t, 4>& parts_micro) noexcept {
  std::int64_t square = 0;
  for (const std::int64_t part : parts_micro) {
    if (!is_within(part, -part_max_micro, part_max_micro)) return false;
    square += part * part;
  }
  return is_within(square, square_min, square_max);
}

}  // namespace

std::optional<DisplayFact> fact_of(const ShownView& view, std::int64_t tick) noexcept {
  if (!is_finite(view)) return std::nullopt;
  const Vec3& target = view.target_in_world_mm;
  const Quat& turn = view.world_from_view;
  DisplayFact fact;
  fact.tick = tick;
  fact.target_in_world_um = {um_from_mm(target.x), um_from_mm(target.y), um_from_mm(target.z)};
  fact.world_from_view_micro = {micro_from_unit(turn.w), micro_from_unit(turn.x),
                                micro_from_unit(turn.y), micro_from_unit(turn.z)};
  fact.magnification_milli = milli_from_ratio(view.magnification);
  fact.target_depth_um = um_from_mm(view.target_depth_mm);
  fact.width_over_height_milli = milli_from_ratio(view.width_over_height);
  fact.stereo = view.stereo;
  fact.layout = view.layout;
  if (!is_view(fact)) return std::nullopt;
  return fact;
}

ShownView shown_view_of(const DisplayFact& fact) noexcept {
  const auto mm = [](std::int64_t um) { return mm_from_um(static_cast<std::int32_t>(um)); };
  const auto unit = [](std::int64_t micro) {
    return unit_from_micro(static_cast<std::int32_t>(micro));
  };
  const auto& target = fact.target_in_world_um;
  const auto& turn = fact.world_from_view_micro;
  ShownView view;
  view.target_in_world_mm = Vec3(mm(target[0]), mm(target[1]), mm(target[2]));
  view.world_from_view =
      normalised(Quat(unit(turn[0]), unit(turn[1]), unit(turn[2]), unit(turn[3])));
  view.magnification = ratio_from_milli(fact.magnification_milli);
  view.target_depth_mm = mm(fact.target_depth_um);
  view.width_over_height = ratio_from_milli(fact.width_over_height_milli);
  view.stereo = fact.stereo;
  view.layout = fact.layout;
  return view;
}

bool is_view(const DisplayFact& fact) noexcept {
  const auto is_in_room = [](std::int64_t part) {
    return is_within(part, -length_max_um, length_max_um);
  };
  return is_within(fact.tick, 0, tick_max) &&
         std::ranges::all_of(fact.target_in_world_um, is_in_room) &&
         is_rotation(fact.world_from_view_micro) &&
         is_within(fact.magnification_milli, 1, magnification_max_milli) &&
         is_in_room(fact.target_depth_um) &&
         is_within(fact.width_over_height_milli, aspect_min_milli, aspect_max_milli) &&
         is_within(fact.lost_before, 0, lost_max);
}

bool is_known(const DisplayFact& fact) noexcept {
  return fact.stereo >= ShownStereo::Mono && fact.stereo <= ShownStereo::Anaglyph &&
         fact.layout >= ShownLayout::Whole && fact.layout <= ShownLayout::WithSection;
}

std::array<std::int64_t, display_columns> columns_of(const DisplayFact& fact) noexcept {
  const auto& target = fact.target_in_world_um;
  const auto& turn = fact.world_from_view_micro;
  return {fact.tick,
          target[0],
          target[1],
          target[2],
          turn[0],
          turn[1],
          turn[2],
          turn[3],
          fact.magnification_milli,
          fact.target_depth_um,
          fact.width_over_height_milli,
          static_cast<std::int64_t>(fact.stereo),
          static_cast<std::int64_t>(fact.layout),
          fact.lost_before};
}

DisplayFact display_fact_from(const std::array<std::int64_t, display_columns>& columns) noexcept {
  DisplayFact fact;
  fact.tick = columns[0];
  std::copy_n(columns.begin() + 1, 3, fact.target_in_world_um.begin());
  std::copy_n(columns.begin() + 4, 4, fact.world_from_view_micro.begin());
  fact.magnification_milli = columns[8];
  fact.target_depth_um = columns[9];
  fact.width_over_height_milli = columns[10];
  fact.stereo = static_cast<ShownStereo>(columns[11]);
  fact.layout = static_cast<ShownLayout>(columns[12]);
  fact.lost_before = columns[13];
  return fact;
}

}  // namespace hallux::simulator
