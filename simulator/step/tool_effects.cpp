#include "simulator/step/tool_effects.h"

#include <algorithm>

#include "simulator/base/units.h"
#include "simulator/contact/bore/bore_tool.h"
#include "simulator/record/sample_force.h"

namespace hallux::simulator {

namespace {

/// The free length asks the bone's surface several times: for a display this is often enough.
constexpr std::int64_t ticks_per_length = 32;

std::span<const DangerCapsule> watched(std::span<const DangerCapsule> zones) noexcept {
  return zones.first(std::min(zones.size(), danger_zone_limit));
}

}  // namespace

ToolEffects::ToolEffects(const RigidTransform& world_from_bone, const SawInHand& hand,
                         std::span<const DangerCapsule> danger_zones)
    : bone_from_world_(inverse(world_from_bone)),
      blade_(hand.saw.blade),
      is_guided_(hand.is_guided),
      heat_(hand.saw),
      danger_(world_from_bone, hand.saw.blade, watched(danger_zones)) {}

void ToolEffects::hold(const Tool& tool) noexcept {
  if (const auto* saw = std::get_if<Saw>(&tool)) {
    blade_ = saw->blade;
    has_blade_ = true;
    heat_.hold(*saw);
    danger_.hold(blade_);
    return;
  }
  has_blade_ = false;
  if (const std::optional<BoreTool> held = bore_tool(tool))
    danger_.hold(DangerShaft{held->shaft_mm, held->radius_mm});
}

void ToolEffects::apply(const ToolSample& sample, const Wound& bone) noexcept {
  tick_ = sample.tick;
  bone_from_tool_ = quantise(bone_from_world_ * transform_from(sample.world_from_tool));
  heat_.apply(sample, bone);
  danger_.apply(sample);
  bend(sample, bone);
}

void ToolEffects::bend(const ToolSample& sample, const Wound& bone) noexcept {
  const bool tells_of_bend = has_blade_ && (!is_guided_ || has(sample.status, ToolStatus::InKerf));
  if (!has(sample.status, ToolStatus::InContact) || !tells_of_bend) {
    flex_ = {};
    return;
  }
  if (flex_.free_length_mm <= 0.0 || sample.tick % ticks_per_length == 0) {
    flex_.free_length_mm = free_length_mm(transform_from(bone_from_tool_), blade_.depth_mm, bone);
  }
  const Vec3 normal = axis_z(transform_from(sample.world_from_tool));
  flex_.deflection_mm = deflection_mm({flex_.free_length_mm, blade_.width_mm, blade_.thickness_mm},
                                      glm::dot(force_newton(sample), normal));
}

bool ToolEffects::take_event(const KerfSet& kerfs, CutEvent& event) noexcept {
  if (DangerNews news; danger_.take_news(news)) {
    event = {tick_, news.has_begun ? CutEventKind::DangerContact : CutEventKind::DangerLeft,
             news.zone, um_from_mm(news.distance_mm), bone_from_tool_};
    return true;
  }
  HeatMark mark;
  if (!heat_.take_mark(mark)) return false;
  const RigidTransform kerf_from_place{Quat{1.0, 0.0, 0.0, 0.0}, Vec3{mark.place_mm, 0.0}};
  event = {tick_, CutEventKind::BoneHot, mark.kerf, 0,
           quantise(kerfs.plane(mark.kerf).bone_from_kerf * kerf_from_place)};
  if (mark.kind == HeatMarkKind::Hot) {
    event.value = round_to_int32(1000.0 * heat_.celsius_at(mark.kerf, mark.place_mm));
  } else {
    event.kind = CutEventKind::BoneNecrosis;
    event.value = round_to_int32(1000.0 * heat_.summary().necrotic_mm3);
  }
  return true;
}

}  // namespace hallux::simulator
