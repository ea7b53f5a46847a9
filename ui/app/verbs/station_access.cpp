#include "ui/app/verbs/station_access.h"

#include "ui/app/terminal/terminal_text.h"
#include "ui/jobs/devices/devices_file.h"
#include "ui/jobs/devices/lent_hand.h"

namespace hallux::ui {

std::unique_ptr<simulator::Station> open_station(const VerbContext& context) {
  return std::make_unique<simulator::Station>(read_devices(context.data_directory));
}

void had_or_not_usable(const std::function<void()>& have) {
  try {
    have();
  } catch (const DeviceRefused& refused) {
    throw VerbError(ExitCode::NoDisplay, terminal_text(refused.what()));
  }
}

simulator::FoundDevice usable_device(simulator::Station& station, const std::string& id) {
  std::optional<simulator::FoundDevice> found = found_now(station, id);
  if (!found) {
    throw VerbError(ExitCode::NoDisplay,
                    terminal_text(id) + ": is not plugged in; `hallux devices` lists what is");
  }
  if (found->kind == simulator::DeviceKind::Mouse)
    throw VerbError(ExitCode::WrongUsage, "the mouse is the window's: open the window to use it");
  had_or_not_usable([&] {
    if (!found->is_usable()) throw DeviceRefused(found->trouble, *found);
  });
  return *std::move(found);
}

}  // namespace hallux::ui
