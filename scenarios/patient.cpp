#include "scenarios/patient.h"

namespace hallux::scenarios {
namespace {

simulator::Bone make_asked(const Scenario& scenario, const PatientRequest& patient,
                           std::span<const FootBone> bones, const Progress& progress) {
  return make_foot_bone(foot_bone_of(scenario, patient, bones),
                        {.length_mm = patient.length_mm,
                         .eminence_mm = patient.eminence_mm,
                         .edge_mm = patient.edge_mm},
                        progress);
}

}  // namespace

const FootBone& foot_bone_of(const Scenario& scenario, const PatientRequest& request,
                             std::span<const FootBone> bones) {
  if (const FootBone* const found = find_foot_bone(request.bone, bones)) return *found;
  throw ScenarioError(scenario.name + ": patient.bone: there is no bone \"" + request.bone +
                      "\"; use one of: " + names_of(bones));
}

simulator::Bone make_patient(const Scenario& scenario, const Progress& progress,
                             std::span<const FootBone> bones) {
  return make_asked(scenario, scenario.patient, bones, progress);
}

}  // namespace hallux::scenarios
