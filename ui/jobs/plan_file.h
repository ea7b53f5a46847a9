/// The planned faces, hinges, danger zones, fragments and implants of an attempt as JSON, for
/// programs of others: the plan.json of an export. Inside this corner only.
///
/// Nothing of ours reads it: it is made from the scenario and the bone, which are sealed.
#pragma once

#include <string>

#include "scenarios/plan.h"

namespace hallux::ui {

inline constexpr const char* plan_file_name = "plan.json";
inline constexpr int plan_file_format = 1;

/// units   mm and degrees, bone frame; its schema is docs/schemas/plan.schema.json
/// ensures the same plan gives the same bytes, UTF-8
/// needs   plan is the scenario's on this bone
std::string plan_file(const scenarios::Scenario& scenario, const simulator::Bones& bones,
                      const scenarios::Plan& plan);

}  // namespace hallux::ui
