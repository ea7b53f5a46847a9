/// A HID device's model behind a hidraw file.
#pragma once

#include <functional>
#include <vector>

#include "tests/support/served_bus/hid_models.h"
#include "tests/support/served_bus/served_device.h"

namespace hallux::tests {

struct HidIdentity {
  std::uint16_t vendor = 0, product = 0;
  std::string name, serial;
  std::vector<std::uint8_t> descriptor;
};

class ServedHid final : public ServedDevice {
 public:
  /// `number` of its file, /dev/hidrawN. `on_tick` lets the model say something of itself once it
  /// is open.
  ServedHid(int number, HidIdentity identity, HidModel& model, std::function<void()> on_tick = {});
  ~ServedHid() override;
  ServedHid(const ServedHid&) = delete;
  ServedHid& operator=(const ServedHid&) = delete;

  std::string description() const override;
  void plugged(UMockdevTestbed& testbed) override;
  void pull() override;
  void tick() override;

 private:
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static gboolean on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  static gboolean on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  void announce();

  HidIdentity identity_;
  HidModel& model_;
  std::function<void()> on_tick_;
  /// A file that can be waited on: one byte in it stands for each report that waits.
  int master_ = -1, slave_ = -1;
  std::size_t announced_ = 0;
  bool is_open_ = false, is_gone_ = false;
};

/// A multi-axis controller with axes to 350.
HidIdentity space_mouse_identity(const std::string& serial = "");
/// The board of an open serial arm.
HidIdentity arm_identity(const std::string& serial = "");
/// A 3D Systems Touch, as far as its numbers go.
HidIdentity touch_identity(const std::string& serial = "");

}  // namespace hallux::tests
