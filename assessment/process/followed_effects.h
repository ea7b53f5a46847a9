/// Heat and danger zones, followed again from the samples as the step followed them: in recordings
/// of older engines, too. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "assessment/process/effect_steps.h"
#include "assessment/process/standing_wound.h"
#include "scenarios/plan.h"
#include "simulator/step/tool_effects.h"

namespace hallux::assessment {

/// When the first contact with a zone began, and the last one was over or the attempt was.
struct ZoneContacts {
  std::int64_t first_tick = 0, last_tick = 0;
  /// Of the teeth's middle at the first contact.
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
};

/// Where and when bone first became too hot, in the frame of the first bone.
struct HeatPlace {
  std::int64_t tick = 0;
  Vec3 place_in_bone_mm{0.0, 0.0, 0.0};
};

class FollowedEffects {
 public:
  /// Borrows the bones.
  FollowedEffects(const simulator::Bones& bones, const simulator::Saw& saw,
                  const scenarios::Plan& plan);

  /// needs   samples in their order; `kerfs` as they stand after the sample
  void follow(const simulator::ToolSample& sample, const simulator::KerfSet& kerfs);

  /// Of each bone as it was, in its frame.
  std::vector<const simulator::Bvh*> surfaces() const;
  /// Per danger zone of the plan.
  const simulator::DangerTrack& zone(std::size_t index) const noexcept {
    return effects_.danger().tracks()[index];
  }
  /// Nothing where it was never touched.
  const std::optional<ZoneContacts>& contacts(std::size_t zone) const noexcept {
    return contacts_[zone];
  }
  /// Of the zone's time and depth (see Measurement::bound).
  double danger_bound_s(std::size_t index) const noexcept {
    return steps_.danger_bound_s(index, zone(index));
  }
  double danger_bound_mm(std::size_t index) const noexcept {
    return steps_.danger_bound_mm(index, zone(index));
  }
  const simulator::HeatSummary& heat() const noexcept { return effects_.heat().summary(); }
  double hot_bound_s() const noexcept { return steps_.hot_bound_s(); }
  double necrotic_bound_mm3() const noexcept {
    return assessment::necrotic_bound_mm3(effects_.heat());
  }
  /// Of bone above 47 degrees, and of bone that heat killed.
  const std::optional<HeatPlace>& hot() const noexcept { return hot_; }
  const std::optional<HeatPlace>& dead() const noexcept { return dead_; }

 private:
  void note(const simulator::CutEvent& event, const simulator::KerfSet& kerfs);

  BoneTissues tissues_;
  simulator::ToolEffects effects_;
  /// In the hand: its place on the tray.
  std::int32_t tool_ = 0;
  EffectSteps steps_;
  std::vector<std::optional<ZoneContacts>> contacts_;
  std::optional<HeatPlace> hot_, dead_;
};

}  // namespace hallux::assessment
