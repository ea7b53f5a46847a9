/// The arms that the service of the Inverse3 has. Inside this corner only.
///
/// One channel is kept for it, so that a list that is made each second does not come and go there.
#pragma once

#include <vector>

#include "simulator/device/inverse3/inverse3_driver.h"

namespace hallux::simulator {

/// The service of this machine at that port.
InverseAccess inverse_access(std::uint16_t port);

struct InverseList {
  std::vector<InverseArm> arms;
  /// Why there is none to be had: NoService, ServiceVersion, ServiceGone.
  TroubleReport trouble;
};

class InverseService {
 public:
  explicit InverseService(std::function<InverseAccess(std::uint16_t)> reach = inverse_access)
      : reach_(std::move(reach)) {}

  /// thread  one at a time
  InverseList look(std::uint16_t port);

 private:
  InverseList begin(std::uint16_t port);
  void take(const InverseMessage& inventory);

  std::function<InverseAccess(std::uint16_t)> reach_;
  std::unique_ptr<ServiceChannel> channel_;
  std::uint16_t port_ = 0;
  /// As they were seen last.
  std::vector<InverseArm> arms_;
};

}  // namespace hallux::simulator
