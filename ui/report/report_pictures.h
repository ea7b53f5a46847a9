/// What a report shows, from an examination.
#pragma once

#include "assessment/assess.h"
#include "simulator/record/guidance.h"
#include "ui/report/report_material.h"

namespace hallux::ui {

/// Card, titles, pictures of the first planned cut, traces and the versions that the card knows.
/// The caller adds facts, quality and what else it knows of versions.
/// needs   the examination is of this scenario, bones and recording, `guidance` the attempt's
ReportMaterial report_material(const scenarios::Scenario& scenario, simulator::Bones bones,
                               const simulator::Recording& recording,
                               const assessment::Examination& examination,
                               simulator::Guidance guidance);

}  // namespace hallux::ui
