#include "simulator/cutting/hole/implant_set.h"

#include <algorithm>

namespace hallux::simulator {

namespace {

bool is_fragment(std::int64_t number, const FragmentPoses& fragments) noexcept {
  return number >= 0 && number < fragments.count();
}

}  // namespace

Capsule capsule_of(const ImplantSize& size, const RigidTransform& frame_from_tool) noexcept {
  // The half balls at the ends are within its length.
  const Vec3 x = axis_x(frame_from_tool);
  const double front_mm = std::min(size.radius_mm, 0.5 * size.length_mm);
  const double back_mm = std::max(size.length_mm - size.radius_mm, front_mm);
  return {frame_from_tool.translation_mm - back_mm * x,
          frame_from_tool.translation_mm - front_mm * x, size.radius_mm};
}

ImplantSet::ImplantSet(const Tray& tray) : tray_(tray) {}

bool ImplantSet::apply(const CutEvent& event, const FragmentPoses& fragments) noexcept {
  switch (event.kind) {
    case CutEventKind::ToolChosen:
      if (!tray_.has(event.subject)) return false;
      tool_ = event.subject;
      return true;
    case CutEventKind::ImplantLeft:
      return leave(event, fragments);
    case CutEventKind::ImplantCarried:
      return carry(event, fragments);
    case CutEventKind::ImplantTaken:
      if (!is_there(event.subject)) return false;
      implants_[static_cast<std::size_t>(event.subject)].is_taken = true;
      return true;
    default:
      return true;
  }
}

bool ImplantSet::leave(const CutEvent& event, const FragmentPoses& fragments) noexcept {
  const std::optional<ImplantSize> size = implant_of(tray_[tool_]);
  if (event.subject != count_ || is_full() || !size || !is_fragment(event.value, fragments))
    return false;
  implants_[static_cast<std::size_t>(count_++)] = {
      tool_, *size, static_cast<std::int32_t>(event.value), transform_from(event.pose), false};
  return true;
}

bool ImplantSet::carry(const CutEvent& event, const FragmentPoses& fragments) noexcept {
  if (!is_there(event.subject) || !is_fragment(event.value, fragments)) return false;
  Implant& implant = implants_[static_cast<std::size_t>(event.subject)];
  implant.fragment = static_cast<std::int32_t>(event.value);
  implant.fragment_from_tool = transform_from(event.pose);
  return true;
}

}  // namespace hallux::simulator
