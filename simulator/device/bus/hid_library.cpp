#include "simulator/device/bus/hid_library.h"

#include <fcntl.h>
#include <hidapi/hidapi.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "simulator/base/utf8.h"

namespace hallux::simulator {

namespace {

constexpr std::size_t descriptor_bytes_most = 4096;

/// The library's wide text as UTF-8.
std::string narrow(const wchar_t* text) {
  std::string narrowed;
  for (; text != nullptr && *text != L'\0'; ++text) {
    append_utf8(narrowed, static_cast<std::uint32_t>(*text));
  }
  return visible_text(narrowed);
}

/// Where the system shows what it knows of a node.
std::filesystem::path system_folder(const std::string& node) {
  return std::filesystem::path("/sys/class/hidraw") / std::filesystem::path(node).filename() /
         "device";
}

std::vector<std::uint8_t> descriptor_of(const std::string& node) {
  std::ifstream in(system_folder(node) / "report_descriptor", std::ios::binary);
  std::vector<std::uint8_t> bytes(descriptor_bytes_most);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(0, in.gcount())));
  return bytes;
}

/// `1-2.3`, the socket that the system has it in; of one that is in none, its own name there.
std::string bus_path_of(const std::string& node) {
  std::error_code ignored;
  const std::filesystem::path real = std::filesystem::canonical(system_folder(node), ignored);
  if (ignored) return {};
  const std::string socket = real.parent_path().filename().string();
  const bool is_socket = !socket.empty() && socket.front() >= '0' && socket.front() <= '9';
  return is_socket ? socket.substr(0, socket.find(':')) : real.filename().string();
}

BusAnswer answer_after(int failed_with) noexcept {
  switch (failed_with) {
    case EIO:
    case ENODEV:
    case ENXIO:
    case EPIPE:
      return BusAnswer::Gone;
    default:
      return BusAnswer::Refused;
  }
}

class OpenHid final : public HidChannel {
 public:
  explicit OpenHid(hid_device* device) : device_(device) {}
  ~OpenHid() override { ::hid_close(device_); }
  OpenHid(const OpenHid&) = delete;
  OpenHid& operator=(const OpenHid&) = delete;

  BusAnswer write(std::span<const std::uint8_t> report) noexcept override {
    errno = 0;
    if (::hid_write(device_, report.data(), report.size()) >= 0) return BusAnswer::Done;
    return answer_after(errno);
  }

  BusRead read(std::span<std::uint8_t> report, std::chrono::milliseconds wait) noexcept override {
    errno = 0;
    const int count =
        ::hid_read_timeout(device_, report.data(), report.size(), static_cast<int>(wait.count()));
    // The library tells a device that is gone from nothing else.
    if (count < 0) return {errno == EINTR ? BusAnswer::Nothing : BusAnswer::Gone, 0};
    return {count == 0 ? BusAnswer::Nothing : BusAnswer::Done, static_cast<std::size_t>(count)};
  }

 private:
  hid_device* device_;
};

}  // namespace

HidLibrary::HidLibrary() { ::hid_init(); }

HidLibrary::~HidLibrary() { ::hid_exit(); }

std::vector<PluggedHid> HidLibrary::plugged() {
  const std::lock_guard lock(mutex_);
  std::vector<PluggedHid> found;
  const std::unique_ptr<hid_device_info, void (*)(hid_device_info*)> all(::hid_enumerate(0, 0),
                                                                         ::hid_free_enumeration);
  for (const hid_device_info* each = all.get(); each != nullptr; each = each->next) {
    PluggedHid hid;
    hid.device = {each->vendor_id,
                  each->product_id,
                  narrow(each->serial_number),
                  narrow(each->product_string),
                  each->path,
                  bus_path_of(each->path)};
    hid.usage = {each->usage_page, each->usage};
    hid.axis_limit = axis_limit_in(descriptor_of(each->path));
    found.push_back(std::move(hid));
  }
  return found;
}

OpenedHid HidLibrary::open(const std::string& node) {
  if (TroubleReport trouble = trouble_with_node(node)) return {nullptr, std::move(trouble)};
  const std::lock_guard lock(mutex_);
  errno = 0;
  if (hid_device* device = ::hid_open_path(node.c_str())) {
    return {std::make_unique<OpenHid>(device), {}};
  }
  return {nullptr, {DeviceTrouble::SystemRefused, node, std::strerror(errno)}};
}

std::string hid_library_version() { return ::hid_version_str(); }

TroubleReport trouble_with_node(const std::string& node) {
  const int file = ::open(node.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
  if (file >= 0) {
    ::close(file);
    return {};
  }
  const int why = errno;
  switch (why) {
    case EACCES:
    case EPERM:
      return {DeviceTrouble::NoPermission, node, std::strerror(why)};
    case EBUSY:
      return {DeviceTrouble::Busy, node, std::strerror(why)};
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return {DeviceTrouble::Unplugged, node, std::strerror(why)};
    default:
      return {DeviceTrouble::SystemRefused, node, std::strerror(why)};
  }
}

}  // namespace hallux::simulator
