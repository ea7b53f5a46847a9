#include "simulator/history/bone_moment.h"

#include <limits>

namespace hallux::simulator {

BoneMoment::BoneMoment(const BoneHistory& history) : history_(history) {
  for (std::size_t i = 0; i < history.fragments.size(); ++i)
    fragments_.push_back({FragmentMoment(history, static_cast<std::int32_t>(i))});
}

void BoneMoment::move_to(std::int64_t tick) {
  tick_ = tick;
  bool has_moved = false;
  for (std::int32_t number = 0; number < fragment_count(); ++number) {
    Shown& shown = fragments_[static_cast<std::size_t>(number)];
    if (shown.moment.move_to(tick)) shown.revision = ++revision_;
    const std::size_t step = history_of(number).path.step_at(tick);
    has_moved = has_moved || (shown.path_step != step && shown.moment.is_there());
    shown.path_step = step;
  }
  if (has_moved) ++revision_;
}

std::vector<const ImplantStay*> BoneMoment::implants() const {
  std::vector<const ImplantStay*> standing;
  for (const ImplantStay& stay : history_.metal.implants) {
    if (stay.is_there(tick_) && fragment(stay.implant.fragment).is_there())
      standing.push_back(&stay);
  }
  return standing;
}

std::vector<RimInMoment> BoneMoment::rims() const {
  std::vector<RimInMoment> rims;
  for (std::int32_t number = 0; number < fragment_count(); ++number) {
    if (!fragment(number).is_there()) continue;
    for (const BoreRim& each : history_of(number).stretches[fragment(number).stretch()].rims) {
      const BoreGrowth& bore = history_.metal.bores[each.bore];
      const double depth_mm = bore.depth_mm_at(tick_);
      const bool is_open = tick_ >= bore.from_tick && depth_mm > 0.0 && tick_ < each.gone_tick &&
                           each.rim.way_mm <= bore.opened_mm_at(tick_);
      if (!is_open) continue;
      const Vec3 along = axis_x(bore.at_last.bore.body_from_bore);
      rims.push_back({number, &each.rim, each.rim.way_mm < 0.5 * depth_mm ? -along : along});
    }
  }
  return rims;
}

std::optional<KerfAtHand> BoneMoment::kerf_at_hand() {
  std::int32_t newest = -1, newest_tick = -1;
  for (std::size_t kerf = 0; kerf < history_.kerfs.size(); ++kerf) {
    const KerfGrowth& growth = history_.kerfs[kerf];
    const std::size_t grown = growth.grown_at(tick_);
    if (grown == 0 || growth.ticks[grown - 1] < newest_tick) continue;
    newest = static_cast<std::int32_t>(kerf);
    newest_tick = growth.ticks[grown - 1];
  }
  if (newest < 0) return std::nullopt;
  const KerfGrowth& growth = history_.kerfs[static_cast<std::size_t>(newest)];
  if (growth.fragment >= fragment_count()) return std::nullopt;
  FragmentMoment& fragment = fragments_[static_cast<std::size_t>(growth.fragment)].moment;
  return KerfAtHand{growth.fragment, {growth.opened.plane, loops_of(fragment.outline_of(newest))}};
}

std::optional<PlaceOnFragment> BoneMoment::first_hit(const Vec3& from_in_world_mm,
                                                     const Vec3& direction_in_world) const {
  std::optional<PlaceOnFragment> first;
  double least_mm = std::numeric_limits<double>::infinity();
  for (std::int32_t number = 0; number < fragment_count(); ++number) {
    const RigidTransform fragment_from_world = inverse(world_from_fragment(number));
    const Vec3 from_mm = transform_point(fragment_from_world, from_in_world_mm);
    const Vec3 direction = transform_direction(fragment_from_world, direction_in_world);
    const std::optional<double> hit_mm = fragment(number).first_hit_mm(from_mm, direction);
    if (!hit_mm || *hit_mm >= least_mm) continue;
    least_mm = *hit_mm;
    first = PlaceOnFragment{number, from_mm + *hit_mm * direction};
  }
  return first;
}

}  // namespace hallux::simulator
