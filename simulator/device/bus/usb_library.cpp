#include "simulator/device/bus/usb_library.h"

#include <libusb.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "simulator/base/utf8.h"

namespace hallux::simulator {

namespace {

using Clock = std::chrono::steady_clock;

constexpr unsigned request_patience_ms = 1000;
constexpr std::chrono::milliseconds closing_patience{1000};
constexpr std::size_t ports_deep_most = 7;
/// That wait to be read: more than come while a reader waits for a period.
constexpr std::size_t packets_kept = 16;

struct Packet {
  std::array<std::uint8_t, usb_packet_bytes> bytes{};
  std::size_t size = 0;
};

std::string line_in(const std::filesystem::path& file) {
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return visible_text(line);
}

/// `1-2.3`: the bus, and the sockets from its root to the device; `usb1` for a root itself.
std::string bus_path_of(libusb_device* device) {
  const std::string bus = std::to_string(::libusb_get_bus_number(device));
  std::array<std::uint8_t, ports_deep_most> ports{};
  const int count = ::libusb_get_port_numbers(device, ports.data(), static_cast<int>(ports.size()));
  if (count <= 0) return "usb" + bus;
  std::string path = bus;
  for (int i = 0; i < count; ++i) {
    path += (i == 0 ? '-' : '.') + std::to_string(ports[static_cast<std::size_t>(i)]);
  }
  return path;
}

std::string node_of(libusb_device* device) {
  std::array<char, 64> node{};
  std::snprintf(node.data(), node.size(), "/dev/bus/usb/%03d/%03d", ::libusb_get_bus_number(device),
                ::libusb_get_device_address(device));
  return node.data();
}

PluggedDevice described(libusb_device* device, const libusb_device_descriptor& said) {
  PluggedDevice plugged;
  plugged.vendor = said.idVendor;
  plugged.product = said.idProduct;
  plugged.node = node_of(device);
  plugged.bus_path = bus_path_of(device);
  // The system read these when it was plugged in; asking the device takes rights.
  const std::filesystem::path known =
      std::filesystem::path("/sys/bus/usb/devices") / plugged.bus_path;
  plugged.serial = line_in(known / "serial");
  plugged.product_name = line_in(known / "product");
  return plugged;
}

DeviceTrouble trouble_of(int error) noexcept {
  switch (error) {
    case LIBUSB_ERROR_ACCESS:
      return DeviceTrouble::NoPermission;
    case LIBUSB_ERROR_BUSY:
      return DeviceTrouble::Busy;
    case LIBUSB_ERROR_NO_DEVICE:
    case LIBUSB_ERROR_NOT_FOUND:
      return DeviceTrouble::Unplugged;
    default:
      return DeviceTrouble::SystemRefused;
  }
}

BusAnswer answer_of(int error) noexcept {
  switch (error) {
    case LIBUSB_SUCCESS:
      return BusAnswer::Done;
    case LIBUSB_ERROR_TIMEOUT:
    case LIBUSB_ERROR_BUSY:
      return BusAnswer::Nothing;
    case LIBUSB_ERROR_NO_DEVICE:
      return BusAnswer::Gone;
    default:
      return BusAnswer::Refused;
  }
}

/// One transfer of a pipe that is used again and again; `is_busy` from its start to its end.
struct Pipe {
  libusb_transfer* transfer = nullptr;
  Packet packet;
  bool is_busy = false;
};

/// All of it on its user's thread: the library calls back while it is asked to handle events.
class OpenUsb final : public UsbChannel {
 public:
  OpenUsb(libusb_context* context, libusb_device_handle* device, std::uint8_t pipe_in,
          std::uint8_t pipe_out)
      : context_(context), device_(device) {
    prepare(in_, pipe_in, &OpenUsb::arrived);
    prepare(out_, pipe_out, &OpenUsb::went);
    listen();
  }

  ~OpenUsb() override {
    for (Pipe* pipe : {&in_, &out_})
      if (pipe->is_busy) ::libusb_cancel_transfer(pipe->transfer);
    const auto end = Clock::now() + closing_patience;
    while ((in_.is_busy || out_.is_busy) && Clock::now() < end) handle_events(closing_patience);
    ::libusb_release_interface(device_, 0);
    ::libusb_close(device_);
    // What never ended is still the library's.
    for (Pipe* pipe : {&in_, &out_})
      if (!pipe->is_busy) ::libusb_free_transfer(pipe->transfer);
    ::libusb_exit(context_);
  }
  OpenUsb(const OpenUsb&) = delete;
  OpenUsb& operator=(const OpenUsb&) = delete;

  BusAnswer request(std::uint8_t number, std::uint16_t value) noexcept override {
    constexpr std::uint8_t vendor_to_device = 0x40;
    const int done = ::libusb_control_transfer(device_, vendor_to_device, number, value, 0, nullptr,
                                               0, request_patience_ms);
    return answer_of(std::min(done, 0));
  }

  BusAnswer write(std::span<const std::uint8_t> bytes) noexcept override {
    if (out_.is_busy) handle_events({});
    if (is_gone_) return BusAnswer::Gone;
    if (out_.is_busy) return BusAnswer::Nothing;
    out_.packet.size = std::min(bytes.size(), usb_packet_bytes);
    std::copy_n(bytes.begin(), out_.packet.size, out_.packet.bytes.begin());
    out_.transfer->length = static_cast<int>(out_.packet.size);
    return start(out_);
  }

  BusRead read(std::span<std::uint8_t, usb_packet_bytes> packet,
               std::chrono::milliseconds wait) noexcept override {
    const auto end = Clock::now() + wait;
    if (!in_.is_busy) listen();
    while (kept_count_ == 0 && !is_gone_) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(end - Clock::now());
      if (left.count() < 0) return {BusAnswer::Nothing, 0};
      handle_events(left);
      if (kept_count_ == 0 && Clock::now() >= end) break;
    }
    if (kept_count_ == 0) return {is_gone_ ? BusAnswer::Gone : BusAnswer::Nothing, 0};
    const Packet& oldest = kept_[first_kept_];
    std::copy_n(oldest.bytes.begin(), oldest.size, packet.begin());
    first_kept_ = (first_kept_ + 1) % packets_kept;
    --kept_count_;
    return {BusAnswer::Done, oldest.size};
  }

 private:
  void prepare(Pipe& pipe, std::uint8_t number, void (*called)(libusb_transfer*)) noexcept {
    pipe.transfer = ::libusb_alloc_transfer(0);
    if (pipe.transfer == nullptr) {
      is_gone_ = true;
      return;
    }
    constexpr unsigned for_ever = 0;
    ::libusb_fill_bulk_transfer(pipe.transfer, device_, number, pipe.packet.bytes.data(),
                                static_cast<int>(usb_packet_bytes), called, this, for_ever);
  }

  BusAnswer start(Pipe& pipe) noexcept {
    if (is_gone_) return BusAnswer::Gone;
    const BusAnswer answer = answer_of(::libusb_submit_transfer(pipe.transfer));
    pipe.is_busy = answer == BusAnswer::Done;
    is_gone_ = is_gone_ || answer == BusAnswer::Gone;
    return answer;
  }

  void listen() noexcept { static_cast<void>(start(in_)); }

  void handle_events(std::chrono::milliseconds wait) noexcept {
    timeval patience{wait.count() / 1000, static_cast<suseconds_t>(wait.count() % 1000 * 1000)};
    ::libusb_handle_events_timeout_completed(context_, &patience, nullptr);
  }

  /// Also where the removal's own event is missed: the status of a transfer decides.
  void end(Pipe& pipe) noexcept {
    pipe.is_busy = false;
    if (pipe.transfer->status == LIBUSB_TRANSFER_NO_DEVICE) is_gone_ = true;
  }

  void keep(const Packet& packet) noexcept {
    if (kept_count_ == packets_kept) {
      first_kept_ = (first_kept_ + 1) % packets_kept;
      --kept_count_;
    }
    kept_[(first_kept_ + kept_count_++) % packets_kept] = packet;
  }

  static void arrived(libusb_transfer* transfer) noexcept {
    OpenUsb& self = *static_cast<OpenUsb*>(transfer->user_data);
    self.end(self.in_);
    if (transfer->status == LIBUSB_TRANSFER_CANCELLED) return;
    if (transfer->status == LIBUSB_TRANSFER_COMPLETED) {
      self.in_.packet.size = static_cast<std::size_t>(std::max(0, transfer->actual_length));
      self.keep(self.in_.packet);
    }
    // A pipe that stalls or is in error is tried again when it is read.
    if (transfer->status == LIBUSB_TRANSFER_COMPLETED) self.listen();
  }

  static void went(libusb_transfer* transfer) noexcept {
    OpenUsb& self = *static_cast<OpenUsb*>(transfer->user_data);
    self.end(self.out_);
  }

  libusb_context* context_;
  libusb_device_handle* device_;
  Pipe in_, out_;
  std::array<Packet, packets_kept> kept_{};
  std::size_t first_kept_ = 0, kept_count_ = 0;
  bool is_gone_ = false;
};

/// The devices of a list, and the list itself until it goes.
class DeviceList {
 public:
  explicit DeviceList(libusb_context* context)
      : count_(std::max<std::ptrdiff_t>(0, ::libusb_get_device_list(context, &devices_))) {}
  ~DeviceList() {
    if (devices_ != nullptr) ::libusb_free_device_list(devices_, 1);
  }
  DeviceList(const DeviceList&) = delete;
  DeviceList& operator=(const DeviceList&) = delete;

  std::span<libusb_device*> all() const noexcept {
    return {devices_, static_cast<std::size_t>(count_)};
  }

 private:
  libusb_device** devices_ = nullptr;
  std::ptrdiff_t count_ = 0;
};

OpenedUsb refused(libusb_context* context, int error, const PluggedDevice& device) {
  ::libusb_exit(context);
  return {nullptr, {trouble_of(error), device.node, ::libusb_strerror(error)}};
}

}  // namespace

UsbLibrary::UsbLibrary() {
  if (::libusb_init(&context_) != LIBUSB_SUCCESS) context_ = nullptr;
}

UsbLibrary::~UsbLibrary() {
  if (context_ != nullptr) ::libusb_exit(context_);
}

std::vector<PluggedDevice> UsbLibrary::plugged(std::uint16_t vendor) const {
  std::vector<PluggedDevice> found;
  if (context_ == nullptr) return found;
  const DeviceList list(context_);
  for (libusb_device* device : list.all()) {
    libusb_device_descriptor said{};
    if (::libusb_get_device_descriptor(device, &said) == LIBUSB_SUCCESS && said.idVendor == vendor)
      found.push_back(described(device, said));
  }
  return found;
}

OpenedUsb open_usb(const PluggedDevice& device, std::uint8_t pipe_in, std::uint8_t pipe_out) {
  libusb_context* context = nullptr;
  const int begun = ::libusb_init(&context);
  if (begun != LIBUSB_SUCCESS)
    return {nullptr, {DeviceTrouble::SystemRefused, device.node, ::libusb_strerror(begun)}};
  libusb_device_handle* handle = nullptr;
  int error = LIBUSB_ERROR_NO_DEVICE;
  {
    const DeviceList list(context);
    for (libusb_device* each : list.all())
      if (node_of(each) == device.node) error = ::libusb_open(each, &handle);
  }
  if (error != LIBUSB_SUCCESS) return refused(context, error, device);
  ::libusb_set_auto_detach_kernel_driver(handle, 1);
  error = ::libusb_claim_interface(handle, 0);
  if (error != LIBUSB_SUCCESS) {
    ::libusb_close(handle);
    return refused(context, error, device);
  }
  return {std::make_unique<OpenUsb>(context, handle, pipe_in, pipe_out), {}};
}

std::string usb_library_version() {
  const libusb_version* version = ::libusb_get_version();
  return std::to_string(version->major) + '.' + std::to_string(version->minor) + '.' +
         std::to_string(version->micro);
}

}  // namespace hallux::simulator
