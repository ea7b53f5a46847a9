#include "assessment/process/followed_effects.h"

#include "assessment/process/standing_wound.h"

namespace hallux::assessment {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

std::vector<simulator::DangerCapsule> capsules_of(const scenarios::Plan& plan) {
  std::vector<simulator::DangerCapsule> capsules;
  for (const scenarios::PlannedZone& zone : plan.danger_zones) capsules.push_back(zone.capsule);
  return capsules;
}

}  // namespace

FollowedEffects::FollowedEffects(const simulator::Bone& bone, const simulator::Saw& saw,
                                 const scenarios::Plan& plan)
    : tissue_(bone),
      effects_(bone.world_from_bone, {saw, false}, capsules_of(plan)),
      steps_(saw.blade, plan.danger_zones.size()),
      contacts_(plan.danger_zones.size()) {}

void FollowedEffects::follow(const simulator::ToolSample& sample, const simulator::KerfSet& kerfs) {
  if (kerfs.tool() != tool_) {
    tool_ = kerfs.tool();
    effects_.hold(kerfs.tray()[tool_]);
  }
  effects_.apply(sample, standing_wound(tissue_, kerfs));
  steps_.note(sample, effects_);
  for (CutEvent event; effects_.take_event(kerfs, event);) note(event);
  for (std::size_t index = 0; index < contacts_.size(); ++index) {
    if (contacts_[index] && zone(index).state == simulator::DangerState::Contact)
      contacts_[index]->last_tick = sample.tick;
  }
}

void FollowedEffects::note(const CutEvent& event) {
  const Vec3 place_mm = transform_from(event.pose).translation_mm;
  if (event.kind == CutEventKind::BoneHot && !hot_) hot_ = HeatPlace{event.tick, place_mm};
  if (event.kind == CutEventKind::BoneNecrosis && !dead_) dead_ = HeatPlace{event.tick, place_mm};
  if (event.kind != CutEventKind::DangerContact) return;
  std::optional<ZoneContacts>& contacts = contacts_[static_cast<std::size_t>(event.subject)];
  if (!contacts) contacts = ZoneContacts{event.tick, event.tick, place_mm};
}

}  // namespace hallux::assessment
