#include "simulator/device/inverse3/inverse_service.h"

#include <algorithm>
#include <utility>

#include "simulator/device/bus/service_library.h"

namespace hallux::simulator {

namespace {

constexpr std::chrono::milliseconds answered_within{100};

}  // namespace

InverseAccess inverse_access(std::uint16_t port) {
  return {[port] { return open_service(port); }, [port] { return service_page(port, "/version"); }};
}

InverseList InverseService::look(std::uint16_t port) {
  if (!channel_ || port != port_) return begin(port);
  const bool is_asked = channel_->say(inverse_inventory()) == BusAnswer::Done;
  const HeardMessage heard = is_asked ? channel_->hear(answered_within) : HeardMessage{};
  const auto inventory = heard.answer == BusAnswer::Done ? inverse_message(heard.text)
                                                         : std::optional<InverseMessage>();
  if (!inventory) return begin(port);
  take(*inventory);
  return {arms_, {}};
}

InverseList InverseService::begin(std::uint16_t port) {
  channel_.reset();
  arms_.clear();
  OpenedInverse opened = open_inverse(reach_(port));
  if (opened.trouble) return {{}, opened.trouble};
  channel_ = std::move(opened.channel);
  port_ = port;
  take(opened.inventory);
  return {arms_, {}};
}

/// What a message leaves out stays as it was.
void InverseService::take(const InverseMessage& inventory) {
  std::vector<InverseArm> now(inventory.arms.begin(), inventory.arms.begin() + inventory.arm_count);
  for (InverseArm& arm : now) {
    const auto before = std::find_if(arms_.begin(), arms_.end(),
                                     [&](const InverseArm& each) { return each.id == arm.id; });
    if (before != arms_.end() && arm.type.empty()) arm.type = before->type;
  }
  arms_ = std::move(now);
}

}  // namespace hallux::simulator
