#include "ui/jobs/devices/own_station.h"

#include <utility>

#include "simulator/device/mouse.h"
#include "ui/jobs/devices/devices_file.h"

namespace hallux::ui {

namespace {

/// errors  DeviceRefused
simulator::FoundDevice usable(simulator::Station& station, const std::string& id) {
  std::optional<simulator::FoundDevice> found = found_now(station, id);
  if (!found) {
    throw DeviceRefused(id +
                        ": is not plugged in; plug it in, or choose another device under "
                        "Devices");
  }
  if (!found->is_usable()) throw DeviceRefused(found->trouble, *found);
  return *std::move(found);
}

}  // namespace

std::shared_ptr<simulator::Station> OwnStation::get() {
  const std::lock_guard lock(mutex_);
  if (!station_) station_ = std::make_shared<simulator::Station>(read_devices(data_directory_));
  return station_;
}

void OwnStation::read_again() {
  simulator::StationSettings settings = read_devices(data_directory_);
  const std::lock_guard lock(mutex_);
  if (station_) station_->set(std::move(settings));
}

LentHands OwnStation::lend(const ChosenHands& chosen, const HandStart& start,
                           const Progress& progress) {
  LentHands hands{lend_saw(chosen, start, progress)};
  if (!chosen.second.empty() && chosen.second != chosen.saw)
    hands.second = lend_second(chosen.second, progress);
  return hands;
}

std::unique_ptr<simulator::SteeredDevice> OwnStation::lend_saw(const ChosenHands& chosen,
                                                               const HandStart& start,
                                                               const Progress& progress) {
  if (chosen.saw == mouse_id)
    return std::make_unique<simulator::MouseDevice>(start.world_from_tool);
  const std::shared_ptr<simulator::Station> station = get();
  const simulator::FoundDevice found = usable(*station, chosen.saw);
  bring_home(*station, found, progress);
  return lend_hand(station, found, chosen.own, start);
}

std::unique_ptr<simulator::SecondHand> OwnStation::lend_second(const std::string& id,
                                                               const Progress& progress) {
  const std::shared_ptr<simulator::Station> station = get();
  const simulator::FoundDevice found = usable(*station, id);
  bring_home(*station, found, progress);
  return std::make_unique<simulator::SecondHand>(station, found, station->port_of(id));
}

}  // namespace hallux::ui
