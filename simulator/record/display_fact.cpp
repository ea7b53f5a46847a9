#include "simulator/record/display_fact.h"

#include <algorithm>

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

bool is_rotation(const std::array<std::int64_t, 4>& parts_micro) noexcept {
  std::int64_t square = 0;
  for (const std::int64_t part : parts_micro) {
    if (!is_within(part, -part_max_micro, part_max_micro)) return false;
    square += part * part;
  }
  return is_within(square, square_min, square_max);
}

}  // namespace

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
