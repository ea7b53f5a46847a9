/// The wires and screws that an attempt left in the bone, as they lie in it. Inside this room only.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/rebuild/bodies.h"
#include "simulator/cutting/hole/implant_set.h"
#include "simulator/mesh/bones.h"

namespace hallux::assessment {

/// All points in the first bone as it lies; of what was taken out again, as it lay in the bone that
/// stood when it was left.
struct PlacedImplant {
  bool is_screw = false;
  /// Where its axis first goes into bone from the head or the driver; where it meets none, its end.
  Vec3 entry_in_bone_mm{0.0, 0.0, 0.0}, tip_in_bone_mm{0.0, 0.0, 0.0};
  double diameter_mm = 0.0;
  /// From below the head, or the driver, to the tip.
  double length_mm = 0.0;
  /// Names of the bodies in which at least a millimetre of its axis lies.
  std::vector<std::string> engages;
  /// Crossings of the outer skin of the bone by its axis; sawn faces and the canal are none.
  std::int32_t cortices = 0;
  /// From its axis, entry to tip, to the nearest planned joint surface: a tip that went through one
  /// is far from it again. Nothing where none is planned.
  std::optional<double> tip_to_joint_mm;
  /// How far its tip stands out of bone; 0 where it lies in bone or in its canal, or the axis meets
  /// none.
  double protrusion_mm = 0.0;
  /// When it was left.
  std::int64_t left_tick = 0;
  /// It is in the driver again.
  bool is_taken = false;
  /// Of Plan::fixation's implants, the one that it stands for; nothing of one beyond the plan, and
  /// of one that was taken out for another try.
  std::optional<std::size_t> planned;
  /// How often it was set until it lay there, with the tries that were taken out.
  std::int32_t insertions = 1;
};

/// What an attempt leaves besides solids: implants that are there, and the bone that bores took.
struct Fixation {
  std::vector<PlacedImplant> implants;
  /// What was taken out again, in the order in which it was left.
  std::vector<PlacedImplant> taken;
  /// Of all bodies, with a proven bound; 0 where nothing was bored.
  double holes_mm3 = 0.0, holes_bound_mm3 = 0.0;
};

/// bodies  of that recording, on those bones
Fixation fixation_of(const simulator::Recording& recording, const RebuiltBone& rebuilt,
                     const std::vector<Body>& bodies, const simulator::Bones& bones,
                     const scenarios::Plan& plan);

/// Whether implants hold each body to another one: a screw through both, or two wires that are not
/// parallel.
std::vector<bool> held_by(const Fixation& fixation, const std::vector<Body>& bodies);

}  // namespace hallux::assessment
