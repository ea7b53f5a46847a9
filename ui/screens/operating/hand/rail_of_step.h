/// The plane in which a hand that is led like in a slot is kept.
#pragma once

#include <cstdint>
#include <optional>

#include "scenarios/site/site_watch.h"
#include "simulator/device/rail.h"
#include "ui/jobs/live_attempt.h"

namespace hallux::ui {

/// Of the cut that is made in that step: its own kerf's once it has one, else its plan's. Nothing
/// where the step has no cut, or the blade is in another cut's kerf.
/// held     by the plan's cuts; null before they are known
/// in_kerf  the kerf in which the blade is; -1: none
std::optional<simulator::Rail> rail_of_step(const PreparedCase& prepared_case, std::size_t step,
                                            const std::vector<scenarios::HeldCut>* held,
                                            std::int32_t in_kerf);

}  // namespace hallux::ui
