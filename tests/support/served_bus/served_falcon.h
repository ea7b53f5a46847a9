/// A Falcon's model behind a file of usbfs.
#pragma once

#include <chrono>
#include <list>

#include "tests/support/served_bus/falcon_model.h"
#include "tests/support/served_bus/served_device.h"

namespace hallux::tests {

class ServedFalcon final : public ServedDevice {
 public:
  /// In a socket of its own: `number` from 1.
  ServedFalcon(int number, std::string serial, FalconModel& model);

  std::string description() const override;
  void plugged(UMockdevTestbed& testbed) override;
  void pull() override;

  /// Another program has claimed it.
  bool is_taken = false;

 private:
  /// A transfer that was asked for and not yet fetched.
  struct Transfer {
    GlibPtr<UMockdevIoctlData> urb, buffer;
    std::chrono::steady_clock::time_point due;
    bool is_in = false, is_done = true;
    int status = 0;
  };

  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  void answer(UMockdevIoctlClient* client);
  void tell_capabilities(UMockdevIoctlClient* client);
  void submit(UMockdevIoctlClient* client);
  void fetch(UMockdevIoctlClient* client);
  void discard(UMockdevIoctlClient* client);
  void carry_out(Transfer& transfer);
  void complete_in(Transfer& transfer);

  int number_;
  std::string serial_;
  FalconModel& model_;
  std::list<Transfer> transfers_;
  bool is_gone_ = false;
};

}  // namespace hallux::tests
