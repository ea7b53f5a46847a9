/// What a device needs to stand on the served bus: how the system shows it, and who answers for its
/// file. The library (umockdev) preloads itself into the program under test and carries its system
/// calls here.
#pragma once

#include <umockdev.h>

#include <memory>
#include <mutex>
#include <string>

namespace hallux::tests {

/// Of glib, let go when it goes.
struct Unreference {
  void operator()(void* object) const noexcept { g_object_unref(object); }
};
template <typename Object>
using GlibPtr = std::unique_ptr<Object, Unreference>;

class ServedDevice {
 public:
  virtual ~ServedDevice() = default;

  /// Path below /dev.
  const std::string& node() const noexcept { return node_; }
  /// The folder that the system shows for it.
  const std::string& folder() const noexcept { return folder_; }

  /// How the system shows it, in the library's own words.
  virtual std::string description() const = 0;
  /// After it was plugged in.
  virtual void plugged(UMockdevTestbed&) {}
  virtual void pull() = 0;
  /// Called every millisecond.
  virtual void tick() {}

  UMockdevIoctlBase* calls() noexcept { return calls_.get(); }

 protected:
  ServedDevice(std::string node, std::string folder)
      : node_(std::move(node)), folder_(std::move(folder)), calls_(umockdev_ioctl_base_new()) {}

  /// The library's threads and ours.
  std::mutex mutex_;

 private:
  std::string node_, folder_;
  GlibPtr<UMockdevIoctlBase> calls_;
};

}  // namespace hallux::tests
