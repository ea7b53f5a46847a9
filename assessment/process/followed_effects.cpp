#include "assessment/process/followed_effects.h"

namespace hallux::assessment {

namespace {

using simulator::CutEvent;
using simulator::CutEventKind;

}  // namespace

FollowedEffects::FollowedEffects(const simulator::Bones& bones, const simulator::Saw& saw,
                                 const scenarios::Plan& plan)
    : tissues_(bones),
      effects_(bones.first().world_from_bone, {saw, false}, capsules_of(plan.danger_zones, bones)),
      steps_(saw.blade, plan.danger_zones.size()),
      contacts_(plan.danger_zones.size()) {}

void FollowedEffects::follow(const simulator::ToolSample& sample, const simulator::KerfSet& kerfs) {
  if (kerfs.tool() != tool_) {
    tool_ = kerfs.tool();
    effects_.hold(kerfs.tray()[tool_]);
  }
  effects_.apply(sample, standing_wound(tissues_, kerfs));
  steps_.note(sample, effects_);
  for (CutEvent event; effects_.take_event(kerfs, event);) note(event, kerfs);
  for (std::size_t index = 0; index < contacts_.size(); ++index) {
    if (contacts_[index] && zone(index).state == simulator::DangerState::Contact)
      contacts_[index]->last_tick = sample.tick;
  }
}

std::vector<const simulator::Bvh*> FollowedEffects::surfaces() const {
  std::vector<const simulator::Bvh*> all;
  for (const simulator::TissueMap& tissue : tissues_.maps) all.push_back(&tissue.surface());
  return all;
}

void FollowedEffects::note(const CutEvent& event, const simulator::KerfSet& kerfs) {
  const Vec3 place_mm = transform_from(event.pose).translation_mm;
  const bool is_hot = event.kind == CutEventKind::BoneHot;
  if (is_hot || event.kind == CutEventKind::BoneNecrosis) {
    const std::int32_t bone = kerfs.fragments()[kerfs.fragment_of(event.subject)].bone;
    const RigidTransform& first_from_bone =
        tissues_.first_from_bones[static_cast<std::size_t>(bone)];
    std::optional<HeatPlace>& first = is_hot ? hot_ : dead_;
    if (!first) first = HeatPlace{event.tick, transform_point(first_from_bone, place_mm)};
  }
  if (event.kind != CutEventKind::DangerContact) return;
  std::optional<ZoneContacts>& contacts = contacts_[static_cast<std::size_t>(event.subject)];
  if (!contacts) contacts = ZoneContacts{event.tick, event.tick, place_mm};
}

}  // namespace hallux::assessment
