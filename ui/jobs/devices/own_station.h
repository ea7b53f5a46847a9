/// The station of one window: made when it is first asked for, with what is set beside the
/// database.
#pragma once

#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

#include "ui/jobs/devices/lent_hand.h"

namespace hallux::ui {

/// What operates where no device was chosen.
inline constexpr std::string_view mouse_id = "mouse";

/// With what somebody wants to operate, and how they hold it.
struct ChosenHands {
  /// Of the mouse, or of a device.
  std::string saw;
  /// Of a device for the other hand; empty: none.
  std::string second = {};
  simulator::HandChoice own = {};
};

/// thread  any
class OwnStation {
 public:
  explicit OwnStation(std::filesystem::path data_directory)
      : data_directory_(std::move(data_directory)) {}

  const std::filesystem::path& data_directory() const noexcept { return data_directory_; }

  /// errors  FileRefused, scenarios::ScenarioError: what is set cannot be read
  std::shared_ptr<simulator::Station> get();
  /// What is set has changed: devices that are opened from now on have it.
  /// errors  as get()
  void read_again();

  /// What was chosen, once it was brought home.
  /// errors  as get(); DeviceRefused; Cancelled
  LentHands lend(const ChosenHands& chosen, const HandStart& start, const Progress& progress);

 private:
  std::unique_ptr<simulator::SteeredDevice> lend_saw(const ChosenHands& chosen,
                                                     const HandStart& start,
                                                     const Progress& progress);
  std::unique_ptr<simulator::SecondHand> lend_second(const std::string& id,
                                                     const Progress& progress);

  std::filesystem::path data_directory_;
  std::mutex mutex_;
  /// Under the mutex; null before it is asked for.
  std::shared_ptr<simulator::Station> station_;
};

}  // namespace hallux::ui
