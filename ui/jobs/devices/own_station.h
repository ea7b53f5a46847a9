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

/// thread  any
class OwnStation {
 public:
  explicit OwnStation(std::filesystem::path data_directory)
      : data_directory_(std::move(data_directory)) {}

  const std::filesystem::path& data_directory() const noexcept { return data_directory_; }

  /// errors  FileRefused, scenarios::ScenarioError: what is set cannot be read
  std::shared_ptr<simulator::Station> get();
  /// What is set has changed: whoever asks next has a station with it. What was lent goes on as it
  /// was.
  void forget();

  /// The mouse, or the device with that id once it was brought home; and that for the other hand.
  /// second  its id; empty: none
  /// errors  as get(); DeviceRefused; Cancelled
  LentHands lend(const std::string& id, const std::string& second, const HandStart& start,
                 const Progress& progress);

 private:
  std::unique_ptr<simulator::SteeredDevice> lend_saw(const std::string& id, const HandStart& start,
                                                     const Progress& progress);
  std::unique_ptr<simulator::SecondHand> lend_second(const std::string& id,
                                                     const Progress& progress);

  std::filesystem::path data_directory_;
  std::mutex mutex_;
  /// Under the mutex; null before it is asked for.
  std::shared_ptr<simulator::Station> station_;
};

}  // namespace hallux::ui
