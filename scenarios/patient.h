/// The patient that a scenario asks for: its bones, made from the tables of the foot.
#pragma once

#include <span>
#include <vector>

#include "scenarios/foot/foot_bones.h"
#include "scenarios/scenario.h"
#include "simulator/base/progress.h"
#include "simulator/mesh/bone.h"

namespace hallux::scenarios {

/// The row of the bone that is asked for.
/// errors  ScenarioError naming the rows where none has that name
const FootBone& foot_bone_of(const Scenario& scenario, const PatientRequest& request,
                             std::span<const FootBone> bones = foot_bones());

/// The bones of the patient, in the order in which the scenario asks for them; `progress` is told
/// the fraction done and may return false to cancel.
/// errors  ScenarioError (see make_bone, foot_bone_of)
std::vector<simulator::Bone> make_patient_bones(const Scenario& scenario,
                                                const Progress& progress = {},
                                                std::span<const FootBone> bones = foot_bones());

}  // namespace hallux::scenarios
