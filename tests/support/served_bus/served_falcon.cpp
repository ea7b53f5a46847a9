#include "tests/support/served_bus/served_falcon.h"

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>

namespace hallux::tests {

namespace {

constexpr std::array<std::uint8_t, 18> device_descriptor{
    18, 1, 0x10, 0x01, 0, 0, 0, 8, 0x03, 0x04, 0x48, 0xCB, 0x00, 0x04, 1, 2, 3, 1};
/// One interface, a pipe each way.
constexpr std::array<std::uint8_t, 32> configuration_descriptor{
    9,    2, 32, 0, 1,    1, 0,  0xA0, 45, 9, 4, 0,    0, 2,  0xFF, 0xFF,
    0xFF, 2, 7,  5, 0x81, 2, 64, 0,    0,  7, 5, 0x02, 2, 64, 0,    0};

std::string form(const char* text, int value) {
  std::array<char, 128> made{};
  std::snprintf(made.data(), made.size(), text, value);
  return made.data();
}

std::string hex_descriptors() {
  std::string hex;
  std::array<char, 3> digits{};
  const auto put = [&](std::uint8_t byte) {
    std::snprintf(digits.data(), digits.size(), "%02x", byte);
    hex += digits.data();
  };
  for (const std::uint8_t byte : device_descriptor) put(byte);
  for (const std::uint8_t byte : configuration_descriptor) put(byte);
  return hex;
}

void complete(UMockdevIoctlClient* client, int result, int error) {
  umockdev_ioctl_client_complete(client, result, error);
}

usbdevfs_urb& urb_of(UMockdevIoctlData& data) {
  return *reinterpret_cast<usbdevfs_urb*>(data.data);
}

}  // namespace

ServedFalcon::ServedFalcon(int number, std::string serial, FalconModel& model)
    : ServedDevice(form("bus/usb/%03d/002", number), form("/devices/usb%d", number)),
      number_(number),
      serial_(std::move(serial)),
      model_(model) {
  g_signal_connect(calls(), "handle-ioctl", G_CALLBACK(&ServedFalcon::on_ioctl), this);
}

std::string ServedFalcon::description() const {
  return "P: " + folder() + "\nN: " + node() +
         "\nE: SUBSYSTEM=usb\nE: DRIVER=usb\nE: DEVTYPE=usb_device\nE: BUSNUM=" +
         form("%03d", number_) + "\nE: DEVNUM=002\nE: DEVNAME=/dev/" + node() +
         "\nE: MAJOR=189\nE: MINOR=" + std::to_string(number_) +
         "\nA: bConfigurationValue=1\\n\nA: busnum=" + std::to_string(number_) +
         "\\n\nA: devnum=2\\n\nA: speed=12\\n\nA: idVendor=0403\\n\nA: idProduct=cb48\\n" +
         "\nA: product=Falcon\\n\nA: serial=" + serial_ +
         "\\n\nH: descriptors=" + hex_descriptors() + "\n\n";
}

void ServedFalcon::plugged(UMockdevTestbed&) {
  const std::lock_guard lock(mutex_);
  is_gone_ = false;
}

void ServedFalcon::pull() {
  const std::lock_guard lock(mutex_);
  is_gone_ = true;
}

gboolean ServedFalcon::on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self) {
  static_cast<ServedFalcon*>(self)->answer(client);
  return TRUE;
}

void ServedFalcon::answer(UMockdevIoctlClient* client) {
  const std::lock_guard lock(mutex_);
  const gulong request = umockdev_ioctl_client_get_request(client);
  const bool is_fetching = request == USBDEVFS_REAPURB || request == USBDEVFS_REAPURBNDELAY;
  // What was asked for before the plug was pulled can still be fetched, as failed.
  if (is_gone_ && !is_fetching) return complete(client, -1, ENODEV);
  switch (request) {
    case USBDEVFS_GET_CAPABILITIES:
      return tell_capabilities(client);
    case USBDEVFS_CLAIMINTERFACE:
      return is_taken ? complete(client, -1, EBUSY) : complete(client, 0, 0);
    case USBDEVFS_RELEASEINTERFACE:
    case USBDEVFS_RESET:
    case USBDEVFS_CLEAR_HALT:
      return complete(client, 0, 0);
    case USBDEVFS_DISCONNECT_CLAIM:
      return is_taken ? complete(client, -1, EBUSY) : complete(client, 0, 0);
    case USBDEVFS_GETDRIVER:
      return complete(client, -1, ENODATA);
    case USBDEVFS_SUBMITURB:
      return submit(client);
    case USBDEVFS_REAPURB:
    case USBDEVFS_REAPURBNDELAY:
      return fetch(client);
    case USBDEVFS_DISCARDURB:
      return discard(client);
    default:
      return complete(client, -1, ENOTTY);
  }
}

void ServedFalcon::tell_capabilities(UMockdevIoctlClient* client) {
  const GlibPtr<UMockdevIoctlData> said(umockdev_ioctl_data_resolve(
      umockdev_ioctl_client_get_arg(client), 0, sizeof(std::uint32_t), nullptr));
  const std::uint32_t capabilities = USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_BULK_CONTINUATION |
                                     USBDEVFS_CAP_NO_PACKET_SIZE_LIM |
                                     USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
  std::memcpy(said->data, &capabilities, sizeof(capabilities));
  complete(client, 0, 0);
}

void ServedFalcon::submit(UMockdevIoctlClient* client) {
  Transfer transfer;
  transfer.urb.reset(umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0,
                                                 sizeof(usbdevfs_urb), nullptr));
  transfer.buffer.reset(umockdev_ioctl_data_resolve(
      transfer.urb.get(), G_STRUCT_OFFSET(usbdevfs_urb, buffer),
      static_cast<gsize>(urb_of(*transfer.urb).buffer_length), nullptr));
  carry_out(transfer);
  transfers_.push_back(std::move(transfer));
  complete(client, 0, 0);
}

void ServedFalcon::carry_out(Transfer& transfer) {
  usbdevfs_urb& urb = urb_of(*transfer.urb);
  const std::uint8_t* const bytes = transfer.buffer->data;
  if (urb.type == USBDEVFS_URB_TYPE_CONTROL) {
    urb.actual_length = 0;
    const auto value = static_cast<std::uint16_t>(bytes[2] | bytes[3] << 8);
    if (!model_.request(bytes[1], value)) transfer.status = -EPIPE;
    return;
  }
  if ((urb.endpoint & 0x80U) != 0) {
    transfer.is_in = true;
    transfer.is_done = false;
    transfer.due =
        std::chrono::steady_clock::now() + std::chrono::milliseconds(model_.latency_ms());
    return;
  }
  model_.receive({bytes, static_cast<std::size_t>(urb.buffer_length)});
  urb.actual_length = urb.buffer_length;
}

/// At once where there is something to say, else when the bridge's own time is over.
void ServedFalcon::complete_in(Transfer& transfer) {
  if (is_gone_) {
    transfer.status = -ENODEV;
    transfer.is_done = true;
    return;
  }
  if (!model_.has_news() && std::chrono::steady_clock::now() < transfer.due) return;
  usbdevfs_urb& urb = urb_of(*transfer.urb);
  std::vector<std::uint8_t> packet = model_.packet();
  const int count = std::min(static_cast<int>(packet.size()), urb.buffer_length);
  umockdev_ioctl_data_update(transfer.buffer.get(), 0, packet.data(), count);
  urb.actual_length = count;
  transfer.is_done = true;
}

void ServedFalcon::fetch(UMockdevIoctlClient* client) {
  for (auto transfer = transfers_.begin(); transfer != transfers_.end(); ++transfer) {
    if (!transfer->is_done) complete_in(*transfer);
    if (!transfer->is_done) continue;
    urb_of(*transfer->urb).status = transfer->status;
    const GlibPtr<UMockdevIoctlData> said(umockdev_ioctl_data_resolve(
        umockdev_ioctl_client_get_arg(client), 0, sizeof(void*), nullptr));
    umockdev_ioctl_data_set_ptr(said.get(), 0, transfer->urb.get());
    complete(client, 0, 0);
    transfers_.erase(transfer);
    return;
  }
  complete(client, -1, EAGAIN);
}

void ServedFalcon::discard(UMockdevIoctlClient* client) {
  gulong wanted = 0;
  std::memcpy(&wanted, umockdev_ioctl_client_get_arg(client)->data, sizeof(wanted));
  for (Transfer& each : transfers_) {
    if (each.urb->client_addr != wanted || each.is_done) continue;
    each.is_done = true;
    each.status = -ENOENT;
    return complete(client, 0, 0);
  }
  complete(client, -1, EINVAL);
}

}  // namespace hallux::tests
