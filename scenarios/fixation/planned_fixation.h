/// Fragments, shifts and implants of a scenario on one patient. All of them say the index of the
/// bone in whose frame they lie.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "scenarios/fixation/fixation.h"
#include "simulator/base/transform.h"

namespace hallux::scenarios {

struct PlannedFragment {
  std::string name;
  std::size_t bone = 0;
  /// Before it is shifted.
  Vec3 holds_in_bone_mm{0.0, 0.0, 0.0};
  /// Counted in cells of a millimetre.
  double volume_mm3 = 0.0;
  /// Carries it to where all of its shifts and closed hinges bring it; how far a shift is closed
  /// until faces touch is not foreseen.
  RigidTransform bone_from_rest = {};
  /// Up, where the foot stands.
  Vec3 foot_dorsal_in_bone{0.0, 1.0, 0.0};
};

struct PlannedShift {
  std::string name, fragment;
  std::size_t bone = 0;
  /// Carries the fragment from where it was cut: the shifts and hinges before this one.
  RigidTransform before_from_cut = {};
  /// Carries it on from there. Both are said in the bone frame.
  RigidTransform bone_from_before = {};
  /// Then it is closed until the faces touch.
  bool is_closed = false;

  RigidTransform bone_from_cut() const noexcept { return bone_from_before * before_from_cut; }
};

struct PlannedClearance {
  std::string joint_surface;
  double least_mm = 0.0;
  /// From the axis between entry and tip, at the nearest, with the fragments shifted.
  double planned_mm = 0.0;
};

struct PlannedImplant {
  ImplantKind kind = ImplantKind::Wire;
  std::string name;
  std::size_t bone = 0;
  Vec3 entry_in_bone_mm{0.0, 0.0, 0.0}, tip_in_bone_mm{0.0, 0.0, 0.0};
  /// Unit, from the entry to the tip.
  Vec3 direction_in_bone{1.0, 0.0, 0.0};
  double length_mm = 0.0, diameter_mm = 0.0;
  /// What is as good.
  Range lengths = {}, diameters = {};
  /// As the scenario says them: fragments, and bones for the rest of a bone.
  std::vector<std::string> engages;
  int cortices = 1;
  std::vector<PlannedClearance> clear_of = {};
  bool is_temporary = false;
};

/// In the order of the scenario, each.
struct PlannedFixation {
  std::vector<PlannedFragment> fragments;
  std::vector<PlannedShift> shifts;
  std::vector<PlannedImplant> implants;
};

/// Null where there is none of that name; what is returned lives as long as the fixation.
const PlannedFragment* find_fragment(const PlannedFixation& fixation,
                                     std::string_view name) noexcept;
const PlannedShift* find_shift(const PlannedFixation& fixation, std::string_view name) noexcept;
const PlannedImplant* find_implant(const PlannedFixation& fixation, std::string_view name) noexcept;

}  // namespace hallux::scenarios
