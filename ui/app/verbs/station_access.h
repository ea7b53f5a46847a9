/// A device of this station for a verb that needs one, or the sentence that says why not.
/// Inside this corner only.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "simulator/device/station/station.h"
#include "ui/app/verbs/verb.h"

namespace hallux::ui {

/// The station with what is set for it beside the database.
/// errors  FileRefused, scenarios::ScenarioError
std::unique_ptr<simulator::Station> open_station(const VerbContext& context);

/// errors  VerbError: NoDisplay in place of DeviceRefused
void had_or_not_usable(const std::function<void()>& have);

/// A device that is plugged in and can be used.
/// errors  VerbError: NoDisplay with the reason and its mend; WrongUsage for the mouse
simulator::FoundDevice usable_device(simulator::Station& station, const std::string& id);

}  // namespace hallux::ui
