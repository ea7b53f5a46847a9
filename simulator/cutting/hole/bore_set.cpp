#include "simulator/cutting/hole/bore_set.h"

namespace hallux::simulator {

namespace {

/// Bores whose radius differs by less are as thick.
constexpr double same_radius_mm = 1.0e-6;

RigidTransform world_from(const BorePlace& place, const FragmentPoses& fragments) noexcept {
  return fragments[place.fragment].world_from_fragment * place.bore.body_from_bore;
}

bool is_as_thick(const Bore& bore, const Bore& other) noexcept {
  const double wider_mm = bore.radius_mm - other.radius_mm;
  return wider_mm < same_radius_mm && wider_mm > -same_radius_mm;
}

}  // namespace

BoreSet::BoreSet(const Tray& tray) : tray_(tray) {}

bool BoreSet::is_entered_in(std::int32_t fragment) const noexcept {
  for (std::size_t i = 0; i < place_count_; ++i) {
    if (is_open_[i] && places_[i].fragment == fragment) return true;
  }
  return false;
}

std::int32_t BoreSet::place_of(std::int32_t number, std::int32_t fragment) const noexcept {
  for (std::size_t i = 0; i < place_count_; ++i) {
    if (places_[i].number == number && places_[i].fragment == fragment)
      return static_cast<std::int32_t>(i);
  }
  return -1;
}

bool BoreSet::apply(const CutEvent& event, const FragmentPoses& fragments) noexcept {
  switch (event.kind) {
    case CutEventKind::ToolChosen:
      if (!tray_.has(event.subject)) return false;
      tool_ = event.subject;
      return true;
    case CutEventKind::BoreBegun:
      return begin(event, fragments);
    case CutEventKind::BoreEntered:
      return enter(place_of(event.subject, static_cast<std::int32_t>(event.value)), fragments);
    case CutEventKind::FragmentParted:
      part(static_cast<std::int32_t>(event.value), fragments.count() - 1);
      return true;
    default:
      return true;
  }
}

bool BoreSet::begin(const CutEvent& event, const FragmentPoses& fragments) noexcept {
  const bool is_next =
      event.subject == count_ && !is_full() && event.value >= 0 && event.value < fragments.count();
  const double radius_mm = bored_radius_mm(tray_[tool_]);
  if (!is_next || !(radius_mm > 0.0)) return false;
  BorePlace& place = places_[place_count_++];
  place = {count_++, static_cast<std::int32_t>(event.value), tool_,
           Bore{transform_from(event.pose), radius_mm, 0.0}};
  return enter(static_cast<std::int32_t>(place_count_) - 1, fragments);
}

bool BoreSet::enter(std::int32_t place, const FragmentPoses& fragments) noexcept {
  if (place < 0) return false;
  const BorePlace& entered = places_[static_cast<std::size_t>(place)];
  const RigidTransform axis = world_from(entered, fragments);
  for (std::size_t i = 0; i < place_count_; ++i) {
    is_open_[i] = is_as_thick(places_[i].bore, entered.bore) &&
                  is_along(axis, world_from(places_[i], fragments));
  }
  entered_ = entered.number;
  return true;
}

/// Without a place left the fragment feels no hole; nothing that is scored is lost.
void BoreSet::part(std::int32_t parent, std::int32_t fragment) noexcept {
  const std::size_t before = place_count_;
  for (std::size_t i = 0; i < before && place_count_ < bore_place_limit; ++i) {
    if (places_[i].fragment != parent) continue;
    places_[place_count_] = places_[i];
    places_[place_count_++].fragment = fragment;
  }
}

void BoreSet::apply(const ToolSample& sample, const FragmentPoses& fragments) noexcept {
  if (!has(sample.status, ToolStatus::InBore)) {
    entered_ = -1;
    is_open_ = {};
    return;
  }
  if (!has(sample.status, ToolStatus::DriveOn)) return;
  const RigidTransform world_from_tool = transform_from(sample.world_from_tool);
  for (std::size_t i = 0; i < place_count_; ++i) {
    if (!is_open_[i]) continue;
    BorePlace& place = places_[i];
    open_bore(place.bore, fragments[place.fragment].fragment_from_world * world_from_tool);
  }
}

}  // namespace hallux::simulator
