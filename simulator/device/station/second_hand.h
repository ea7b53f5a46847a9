/// The other hand: a 3D mouse that turns what the first hand holds, or the view.
#pragma once

#include <memory>
#include <string>

#include "simulator/device/mouse.h"
#include "simulator/device/rate_control.h"
#include "simulator/device/station/station.h"

namespace hallux::simulator {

class SecondHand {
 public:
  /// The station stays for as long as it is held.
  SecondHand(std::shared_ptr<Station> station, FoundDevice device,
             std::shared_ptr<DevicePort> port);
  /// It is given back.
  ~SecondHand();
  SecondHand(const SecondHand&) = delete;
  SecondHand& operator=(const SecondHand&) = delete;

  /// The kind's id.
  std::string kind() const { return std::string(facts_of(device_.kind).id); }
  /// What its cap asks for in so long, as the person sees it; nothing while it is away.
  /// thread  window
  PointerMotion motion(double duration_s) noexcept;

 private:
  std::shared_ptr<Station> station_;
  FoundDevice device_;
  std::shared_ptr<DevicePort> port_;
};

/// What a deflection asks for in so long: the law of a 3D mouse that leads, without its smoothing.
PointerMotion motion_of(const Deflection& deflection, double duration_s,
                        const RateSettings& settings = {}) noexcept;

}  // namespace hallux::simulator
