/// A patient whose bones have a size and no surface, at once: for tests that are not about what the
/// picture shows.
#pragma once

#include "simulator/base/progress.h"
#include "ui/screens/pictures/patient_pictures.h"

namespace hallux::ui {

inline PatientView no_patient(const scenarios::Scenario& scenario, const Progress&) {
  PatientView view;
  view.scenario_name = scenario.name;
  view.bone.mesh.high_mm = Vec3(20.0);
  view.neighbour.emplace().mesh.high_mm = Vec3(20.0);
  view.neighbour->world_from_bone.translation_mm = Vec3(30.0, 0.0, 0.0);
  return view;
}

}  // namespace hallux::ui
