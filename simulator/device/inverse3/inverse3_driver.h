/// The driver of a Haply Inverse3, which its maker's service speaks for. Inside this corner only.
///
/// It measures no rotation itself; where a grip of its maker's is in the hand, that turns the saw.
/// Whether a force was understood is told by what the service says that it gives, not by its pages.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "simulator/device/bus/service_channel.h"
#include "simulator/device/inverse3/inverse_message.h"
#include "simulator/device/port/device_driver.h"

namespace hallux::simulator {

/// Where its service listens, unless it was told otherwise; always of this machine.
inline constexpr std::uint16_t inverse_port = 10001;

/// How its service is reached; a test plays both.
struct InverseAccess {
  std::function<OpenedService()> open;
  /// Its page about its version; nothing: it has none.
  std::function<std::optional<std::string>()> version_page;
};

/// A channel whose service has told everything that it knows.
struct OpenedInverse {
  /// None where there was a trouble.
  std::unique_ptr<ServiceChannel> channel;
  InverseMessage inventory;
  InverseForceKey force_key = InverseForceKey::Values;
  TroubleReport trouble;
};

/// errors  in the trouble: NoService, ServiceVersion, ServiceGone
OpenedInverse open_inverse(const InverseAccess& access);

/// What keeps an arm of an inventory from being used.
TroubleReport trouble_with_inverse(const InverseArm& arm);

class Inverse3Driver final : public DeviceDriver {
 public:
  /// `id` as the service names it.
  Inverse3Driver(InverseAccess access, std::string id);

  TroubleReport open(const OpeningWatch& watch) override;
  DeviceDescription description() const override;
  DriverExchange exchange(const Vec3& force_in_device_newton) noexcept override;
  void close() noexcept override;

 private:
  /// What the service says of the forces that it was told.
  struct Belief {
    /// Of late, on average [N].
    double said = 0.0, told = 0.0;
    /// Pushes in a row of which it gave nothing.
    int ignored = 0;
    bool was_changed = false;
  };

  BusAnswer say(const Vec3& force_in_device_newton) noexcept;
  /// To the newest of what waits.
  BusAnswer hear(DriverAnswer& answer) noexcept;
  DriverAnswer take(const HeardMessage& heard) noexcept;
  DriverAnswer take(const InverseMessage& message) noexcept;
  void take(const InverseArm& arm) noexcept;
  void take(const InverseGrip& grip) noexcept;
  void believe(const Vec3& told_newton) noexcept;
  /// No force under the word that was not understood, and on with the other.
  void change_word() noexcept;

  InverseAccess access_;
  std::string id_;
  std::unique_ptr<ServiceChannel> channel_;
  InverseForceKey force_key_ = InverseForceKey::Values;
  /// Sent last.
  Vec3 force_newton_{0.0, 0.0, 0.0};
  Belief belief_;
  /// Forces that no state has answered yet.
  int unanswered_ = 0;
  /// States in a row that did not name it.
  int unnamed_ = 0;
  /// A grip was there when it was opened: its rotation is the arm's. States in a row without one.
  bool has_grip_ = false;
  int gripless_ = 0;
  bool is_calibrated_ = true;
  DriverState state_;
};

}  // namespace hallux::simulator
