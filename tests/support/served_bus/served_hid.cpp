#include "tests/support/served_bus/served_hid.h"

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace hallux::tests {

namespace {

std::string hex_of(const std::vector<std::uint8_t>& bytes) {
  std::string hex;
  std::array<char, 3> digits{};
  for (const std::uint8_t byte : bytes) {
    std::snprintf(digits.data(), digits.size(), "%02x", byte);
    hex += digits.data();
  }
  return hex;
}

std::string number_text(const char* form, unsigned a, unsigned b, unsigned c = 0) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), form, a, b, c);
  return text.data();
}

std::string hid_folder(int number, const HidIdentity& identity) {
  return "/devices/virtual/misc/uhid/" + number_text("0003:%04X:%04X.%04X", identity.vendor,
                                                     identity.product,
                                                     static_cast<unsigned>(number) + 1);
}

}  // namespace

ServedHid::ServedHid(int number, HidIdentity identity, HidModel& model,
                     std::function<void()> on_tick)
    : ServedDevice("hidraw" + std::to_string(number),
                   hid_folder(number, identity) + "/hidraw/hidraw" + std::to_string(number)),
      identity_(std::move(identity)),
      model_(model),
      on_tick_(std::move(on_tick)) {
  g_signal_connect(calls(), "handle-ioctl", G_CALLBACK(&ServedHid::on_ioctl), this);
  g_signal_connect(calls(), "handle-read", G_CALLBACK(&ServedHid::on_read), this);
  g_signal_connect(calls(), "handle-write", G_CALLBACK(&ServedHid::on_write), this);
}

ServedHid::~ServedHid() {
  if (slave_ >= 0) ::close(slave_);
}

std::string ServedHid::description() const {
  const std::string hid = folder().substr(0, folder().find("/hidraw/"));
  return "P: " + hid + "\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID=" +
         number_text("0003:%08X:%08X", identity_.vendor, identity_.product) +
         "\nE: HID_NAME=" + identity_.name + "\nE: HID_PHYS=\nE: HID_UNIQ=" + identity_.serial +
         "\nH: report_descriptor=" + hex_of(identity_.descriptor) + "\n\nP: " + folder() +
         "\nN: " + node() + "\nL: device=../..\nE: SUBSYSTEM=hidraw\nE: DEVNAME=/dev/" + node() +
         "\nE: MAJOR=240\nE: MINOR=0\n\n";
}

void ServedHid::plugged(UMockdevTestbed& testbed) {
  const std::lock_guard lock(mutex_);
  master_ = umockdev_testbed_get_dev_fd(&testbed, ("/dev/" + node()).c_str());
  const std::unique_ptr<char, void (*)(void*)> root(umockdev_testbed_get_root_dir(&testbed),
                                                    g_free);
  std::array<char, 256> link{};
  const std::string file = std::string(root.get()) + "/dev/" + node();
  if (::readlink(file.c_str(), link.data(), link.size() - 1) > 0)
    slave_ = ::open(link.data(), O_RDWR | O_NONBLOCK | O_NOCTTY);
  is_gone_ = false;
}

void ServedHid::pull() {
  const std::lock_guard lock(mutex_);
  is_gone_ = true;
  // Who waits wakes up.
  announced_ += ::write(master_, "x", 1) == 1 ? 1U : 0U;
}

void ServedHid::tick() {
  const std::lock_guard lock(mutex_);
  if (!is_open_ || is_gone_) return;
  if (on_tick_) on_tick_();
  announce();
}

/// A byte in the file for each report that waits.
void ServedHid::announce() {
  std::size_t waiting = model_.waiting();
  while (announced_ < waiting && ::write(master_, "x", 1) == 1) ++announced_;
}

gboolean ServedHid::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer served) {
  ServedHid& self = *static_cast<ServedHid*>(served);
  const std::lock_guard lock(self.mutex_);
  const gulong request = umockdev_ioctl_client_get_request(client);
  UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
  const std::vector<std::uint8_t>& bytes = self.identity_.descriptor;
  if (self.is_gone_) {
    umockdev_ioctl_client_complete(client, -1, ENODEV);
    return TRUE;
  }
  if (request == HIDIOCGRDESCSIZE) {
    const GlibPtr<UMockdevIoctlData> size(
        umockdev_ioctl_data_resolve(argument, 0, sizeof(int), nullptr));
    const int count = static_cast<int>(bytes.size());
    std::memcpy(size->data, &count, sizeof(count));
  } else if (request == HIDIOCGRDESC) {
    const GlibPtr<UMockdevIoctlData> said(
        umockdev_ioctl_data_resolve(argument, 0, sizeof(hidraw_report_descriptor), nullptr));
    hidraw_report_descriptor descriptor{};
    descriptor.size = static_cast<std::uint32_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), descriptor.value);
    std::memcpy(said->data, &descriptor, sizeof(descriptor));
  } else {
    umockdev_ioctl_client_complete(client, -1, EINVAL);
    return TRUE;
  }
  self.is_open_ = true;
  umockdev_ioctl_client_complete(client, 0, 0);
  return TRUE;
}

gboolean ServedHid::on_read(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer served) {
  ServedHid& self = *static_cast<ServedHid*>(served);
  const std::lock_guard lock(self.mutex_);
  if (self.is_gone_) {
    umockdev_ioctl_client_complete(client, -1, EIO);
    return TRUE;
  }
  if (!self.model_.has_news()) {
    umockdev_ioctl_client_complete(client, -1, EAGAIN);
    return TRUE;
  }
  std::array<char, 1> token{};
  if (::read(self.slave_, token.data(), token.size()) == 1 && self.announced_ > 0)
    --self.announced_;
  const std::vector<std::uint8_t> report = self.model_.take();
  UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
  const int count = std::min(static_cast<int>(report.size()), argument->data_len);
  umockdev_ioctl_data_update(argument, 0, const_cast<std::uint8_t*>(report.data()), count);
  umockdev_ioctl_client_complete(client, count, 0);
  return TRUE;
}

gboolean ServedHid::on_write(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer served) {
  ServedHid& self = *static_cast<ServedHid*>(served);
  const std::lock_guard lock(self.mutex_);
  if (self.is_gone_) {
    umockdev_ioctl_client_complete(client, -1, ENODEV);
    return TRUE;
  }
  UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
  const auto count = static_cast<std::size_t>(argument->data_len);
  const bool is_taken = self.model_.receive({argument->data, count});
  self.announce();
  umockdev_ioctl_client_complete(client, is_taken ? argument->data_len : -1, is_taken ? 0 : EPIPE);
  return TRUE;
}

HidIdentity space_mouse_identity(const std::string& serial) {
  return {0x256F,
          0xC635,
          "3Dconnexion SpaceMouse Compact",
          serial,
          {0x05, 0x01, 0x09, 0x08, 0xA1, 0x01, 0xA1, 0x00, 0x85, 0x01, 0x16, 0xA2, 0xFE, 0x26, 0x5E,
           0x01, 0x36, 0x88, 0xFA, 0x46, 0x78, 0x05, 0x55, 0x0C, 0x65, 0x11, 0x09, 0x30, 0x09, 0x31,
           0x09, 0x32, 0x75, 0x10, 0x95, 0x03, 0x81, 0x06, 0xC0, 0xA1, 0x00, 0x85, 0x02, 0x09, 0x33,
           0x09, 0x34, 0x09, 0x35, 0x75, 0x10, 0x95, 0x03, 0x81, 0x06, 0xC0, 0xA1, 0x02, 0x85, 0x03,
           0x05, 0x01, 0x05, 0x09, 0x19, 0x01, 0x29, 0x02, 0x15, 0x00, 0x25, 0x01, 0x35, 0x00, 0x45,
           0x01, 0x75, 0x01, 0x95, 0x02, 0x81, 0x02, 0x95, 0x0E, 0x81, 0x03, 0xC0, 0xC0}};
}

HidIdentity touch_identity(const std::string& serial) {
  return {0x2988, 0x0302, "Touch", serial, {0x06, 0x00, 0xFF, 0x09, 0x01, 0xA1, 0x01,
                                            0x09, 0x02, 0x15, 0x00, 0x26, 0xFF, 0x00,
                                            0x75, 0x08, 0x95, 0x40, 0x81, 0x02, 0xC0}};
}

HidIdentity arm_identity(const std::string& serial) {
  return {
      0x16C0, 0x0486, "raw-HID haptic board", serial, {0x06, 0xAB, 0xFF, 0x0A, 0x00, 0x02, 0xA1,
                                                       0x01, 0x75, 0x08, 0x15, 0x00, 0x26, 0xFF,
                                                       0x00, 0x95, 0x40, 0x09, 0x01, 0x81, 0x02,
                                                       0x95, 0x40, 0x09, 0x02, 0x91, 0x02, 0xC0}};
}

}  // namespace hallux::tests
