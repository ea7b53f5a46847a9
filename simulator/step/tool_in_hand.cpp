#include "simulator/step/tool_in_hand.h"

#include "simulator/contact/blade_probe.h"

namespace hallux::simulator {

bool ToolInHand::is_in_bone(const Tray& tray, const Wound& wound) const noexcept {
  if (tray.saw(place_) != nullptr) return blade_is_in_bone(sawing_.tool().bone_from_tool, wound);
  return shaft_is_in_bone(boring_.tool().wound_from_tool, *bore_tool(tray[place_]), wound);
}

void ToolInHand::take_up(const RigidTransform& bone_from_handle, const Tray& tray,
                         const Wound& wound) noexcept {
  if (!is_empty_) return;
  if (tray.saw(place_) != nullptr) {
    sawing_.take_up(bone_from_handle);
  } else {
    boring_.take_up(bone_from_handle);
  }
  is_empty_ = is_in_bone(tray, wound);
}

}  // namespace hallux::simulator
