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

std::vector<simulator::Bone> make_patient_bones(const Scenario& scenario, const Progress& progress,
                                                std::span<const FootBone> bones) {
  const double share = 1.0 / static_cast<double>(1 + scenario.further_bones.size());
  std::vector<simulator::Bone> made;
  made.push_back(make_asked(scenario, scenario.patient, bones, part_of(progress, 0.0, share)));
  for (const PatientRequest& further : scenario.further_bones) {
    const double from = share * static_cast<double>(made.size());
    made.push_back(make_asked(scenario, further, bones, part_of(progress, from, from + share)));
  }
  return made;
}

}  // namespace hallux::scenarios
