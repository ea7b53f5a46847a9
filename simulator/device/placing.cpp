#include "simulator/device/placing.h"

namespace hallux::simulator {

void Placing::set_down(const RigidTransform& device_from_hand,
                       const RigidTransform& world_from_tool) noexcept {
  device_from_hand_ = device_from_hand;
  world_from_tool_ = placed_ = world_from_tool;
  is_lifted_ = false;
}

RigidTransform Placing::place(const RigidTransform& device_from_hand) noexcept {
  if (is_lifted_) return placed_;
  const Quat& turn = frame_.world_from_device;
  const Vec3 way_mm = device_from_hand.translation_mm - device_from_hand_.translation_mm;
  const Quat turned = device_from_hand.rotation * glm::conjugate(device_from_hand_.rotation);
  placed_.translation_mm = world_from_tool_.translation_mm + turn * (frame_.motion_scale * way_mm);
  placed_.rotation = normalised(turn * turned * glm::conjugate(turn) * world_from_tool_.rotation);
  return placed_;
}

}  // namespace hallux::simulator
