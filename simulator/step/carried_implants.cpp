#include "simulator/step/carried_implants.h"

#include <algorithm>
#include <cmath>

namespace hallux::simulator {

namespace {

/// The way along an axis is gone in steps of this at the least: nearer to a surface than that,
/// otherwise as far as there is none.
constexpr double least_step_mm = 0.25;
double way_in_bone_mm(const WoundFragment& standing, const Segment& axis_in_fragment) noexcept {
  const Vec3 way = axis_in_fragment.to - axis_in_fragment.from;
  const double length_mm = length_of(way);
  double within_mm = 0.0;
  for (double at_mm = 0.0; at_mm < length_mm;) {
    const Vec3 point = axis_in_fragment.from + (at_mm / length_mm) * way;
    const double clearance_mm = standing.tissue.clearance_mm(point);
    const double step_mm =
        std::min(std::max(least_step_mm, std::abs(clearance_mm)), length_mm - at_mm);
    if (clearance_mm < 0.0) within_mm += step_mm;
    at_mm += step_mm;
  }
  return within_mm;
}

bool joins(const Implant& implant, std::int32_t fragment, const Wound& wound) noexcept {
  if (!stands(implant, wound) || engaged_mm(implant, fragment, wound) < engaged_least_mm)
    return false;
  for (std::int32_t other = 0; other < fragment_limit; ++other) {
    if (other == fragment || wound.fragment(other) == nullptr) continue;
    if (engaged_mm(implant, other, wound) >= engaged_least_mm) return true;
  }
  return false;
}

}  // namespace

bool stands(const Implant& implant, const Wound& wound) noexcept {
  return !implant.is_taken && wound.fragment(implant.fragment) != nullptr;
}

RigidTransform wound_from_implant(const Implant& implant, const Wound& wound) noexcept {
  return wound.fragment(implant.fragment)->wound_from(implant.fragment_from_tool);
}

double engaged_mm(const Implant& implant, std::int32_t fragment, const Wound& wound) noexcept {
  const WoundFragment& standing = *wound.fragment(fragment);
  if (!stands(implant, wound)) return 0.0;
  const Segment axis = axis_of(capsule_of(implant.size, wound_from_implant(implant, wound)));
  return way_in_bone_mm(standing, {standing.point_from(axis.from), standing.point_from(axis.to)});
}

void StandingMetal::update(const ImplantSet& implants, const Wound& wound) noexcept {
  count_ = 0;
  for (const Implant& implant : implants.all()) {
    Capsule& capsule = capsules_[count_++];
    capsule = stands(implant, wound) ? capsule_of(implant.size, wound_from_implant(implant, wound))
                                     : Capsule{{}, {}, 0.0};
  }
}

void CarriedImplants::part(std::int32_t parent, std::int32_t fragment,
                           const ImplantSet& implants) noexcept {
  for (std::int32_t i = 0; i < implants.count(); ++i) {
    if (implants.is_there(i) && implants[i].fragment == parent)
      asked_[static_cast<std::size_t>(i)] = {parent, fragment};
  }
}

/// Both fragments had one frame when they parted: in it they are asked, wherever they lie now.
void CarriedImplants::carry_next(const Wound& wound, StepWriter& out) noexcept {
  const ImplantSet& implants = out.record().implants();
  const auto next = std::find_if(asked_.begin(), asked_.end(),
                                 [](const Asked& asked) { return asked.fragment >= 0; });
  if (next == asked_.end()) return;
  const Asked asked = *next;
  *next = {};
  const auto number = static_cast<std::int32_t>(next - asked_.begin());
  const WoundFragment* const parted = wound.fragment(asked.fragment);
  const WoundFragment* const left = wound.fragment(asked.parent);
  if (!implants.is_there(number) || parted == nullptr) return;
  const Implant& implant = implants[number];
  const Segment axis = axis_of(capsule_of(implant.size, implant.fragment_from_tool));
  const double left_mm = left == nullptr ? 0.0 : way_in_bone_mm(*left, axis);
  if (way_in_bone_mm(*parted, axis) <= left_mm) return;
  out.say(CutEventKind::ImplantCarried, number, asked.fragment,
          quantise(implant.fragment_from_tool));
}

ImplantHold hold_of(std::int32_t fragment, const ImplantSet& implants,
                    const Wound& wound) noexcept {
  ImplantHold hold;
  for (const Implant& implant : implants.all()) {
    if (!joins(implant, fragment, wound)) continue;
    const RigidTransform pose = wound_from_implant(implant, wound);
    const Vec3 axis = axis_x(pose);
    if (implant.size.is_screw) hold.is_fixed = true;
    if (!hold.joint) {
      hold.joint = WoundJoint{pose.translation_mm, axis, 0.0};
      continue;
    }
    hold.joint->moves = JointMotion::Slide;
    if (length_of(glm::cross(axis, hold.joint->axis)) > parallel_sine) hold.is_fixed = true;
  }
  return hold;
}

}  // namespace hallux::simulator
