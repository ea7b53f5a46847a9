/// Messages to and from a service of this machine, over a WebSocket. Inside this corner only.
#pragma once

#include <chrono>
#include <memory>
#include <string>
#include <string_view>

#include "simulator/device/bus/bus_answer.h"
#include "simulator/device/port/device_trouble.h"

namespace hallux::simulator {

/// Of a message that is taken; a longer one is refused.
inline constexpr std::size_t service_message_bytes = 65536;

struct HeardMessage {
  /// Refused: it was longer than any that we take.
  BusAnswer answer = BusAnswer::Nothing;
  /// Valid until the channel is asked again.
  std::string_view text = {};
};

class ServiceChannel {
 public:
  virtual ~ServiceChannel() = default;

  /// One message, whole.
  virtual BusAnswer say(std::string_view text) noexcept = 0;
  /// The next that came; waits for it so long.
  virtual HeardMessage hear(std::chrono::milliseconds wait) noexcept = 0;
};

struct OpenedService {
  /// None where there was a trouble.
  std::unique_ptr<ServiceChannel> channel;
  TroubleReport trouble;
};

}  // namespace hallux::simulator
