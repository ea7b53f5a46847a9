#include "simulator/device/station/second_hand.h"

#include <utility>

namespace hallux::simulator {

SecondHand::SecondHand(std::shared_ptr<Station> station, FoundDevice device,
                       std::shared_ptr<DevicePort> port)
    : station_(std::move(station)), device_(std::move(device)), port_(std::move(port)) {}

SecondHand::~SecondHand() { station_->close(device_.id); }

PointerMotion SecondHand::motion(double duration_s) noexcept {
  const PortState& state = port_->newest();
  if (state.phase != PortPhase::Running) return {};
  return motion_of(state.said.deflection, duration_s);
}

PointerMotion motion_of(const Deflection& deflection, double duration_s,
                        const RateSettings& settings) noexcept {
  const Vec3 way_mm =
      duration_s * settings.speed_mm_s * rate_response(deflection.pushed, settings.dead_share);
  const Vec3 turn_rad =
      duration_s * settings.turn_rad_s * rate_response(deflection.turned, settings.dead_share);
  PointerMotion motion;
  motion.across_mm = {way_mm.x, way_mm.y};
  motion.deeper_mm = -way_mm.z;
  motion.turned_rad = {turn_rad.y, -turn_rad.x};
  motion.rolled_rad = turn_rad.z;
  return motion;
}

}  // namespace hallux::simulator
