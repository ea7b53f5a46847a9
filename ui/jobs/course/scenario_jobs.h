/// What verbs and screens do with scenarios: list the shipped ones, and check a file on the patient
/// it asks for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "scenarios/plan.h"
#include "scenarios/scenario.h"

namespace hallux::ui {

/// The scenarios that come with the program, in the order of their names.
/// errors  none for a program whose tests pass: the shipped files are read in them
std::vector<scenarios::Scenario> list_scenarios();

/// A shipped scenario by its name, or the one in the file of that name.
/// errors  ScenarioError naming the shipped ones where it is neither
scenarios::Scenario load_scenario(const std::string& name_or_file);

struct CheckedScenario {
  scenarios::Scenario scenario;
  /// The patient at a coarse edge length, and on it where the planes lie, not what is cut.
  std::vector<simulator::Bone> bones;
  scenarios::Plan plan;
};

/// Reads the file and lays each of its planes on its patient, built coarsely. About a second.
/// errors  ScenarioError naming the file, the place and the mend
/// thread  any; it is a job: not the render thread
CheckedScenario check_scenario_file(const std::filesystem::path& file);

/// The whole scenario as readable text: every number with its origin, and whether a surgeon
/// reviewed it.
std::string scenario_sheet(const scenarios::Scenario& scenario);

}  // namespace hallux::ui
