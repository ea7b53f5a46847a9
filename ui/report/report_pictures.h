/// What a report shows, from an examination.
#pragma once

#include "assessment/assess.h"
#include "ui/report/report_material.h"

namespace hallux::ui {

/// Card, titles, pictures of the first planned cut, traces and the versions that the card knows. The caller adds facts,
/// quality and what else it knows of versions.
/// needs   the examination is of this scenario, bone and recording
ReportMaterial report_material(const scenarios::Scenario& scenario, const simulator::Bone& bone,
                               const simulator::Recording& recording,
                               const assessment::Examination& examination);

/// How often and how long the running saw was in each danger zone of the scenario, in its order.
std::vector<ZoneContact> zone_contacts(const scenarios::Scenario& scenario,
                                       const simulator::Recording& recording);

/// Force, feed, advance and heat in at most `points_max` stretches of equal time.
Traces traces_of(const simulator::Recording& recording, const simulator::Bone& bone,
                 const scenarios::SawBlade& blade, const simulator::KerfSet& kerfs,
                 std::size_t points_max = 480);

}  // namespace hallux::ui
