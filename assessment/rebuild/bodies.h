/// The bodies of a bone as an attempt left them: where each lies now, how far it came from where it
/// was cut, and how it stands against the others. Inside this room only.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/rebuild/rebuild.h"
#include "scenarios/plan.h"
#include "simulator/mesh/bvh.h"

namespace hallux::assessment {

/// A connected part of a bone.
struct Body {
  /// Of the planned fragment that it is; of the rest of a bone, the bone's; else "body-2", by its
  /// place among the pieces.
  std::string name;
  /// Of RebuiltBone::pieces.
  std::size_t piece = 0;
  /// That it goes along with; -1: it was taken out.
  std::int32_t fragment = 0;
  /// Of the patient's bones, in whose frame it is said.
  std::size_t bone = 0;
  /// From where it was cut to where it lies.
  RigidTransform bone_from_piece;
  /// The same in the frame of the first bone: where bodies of several meet.
  RigidTransform first_from_piece;
  /// Where it was cut.
  Vec3 centroid_in_bone_mm{0.0, 0.0, 0.0};
  double volume_mm3 = 0.0;
  /// Over its surface, where it was cut.
  std::unique_ptr<const simulator::Bvh> tree;
};

/// The plan's hinges; where it asks how fragments lie, their halves are bodies of their own.
ClosedHinges hinges_of(const scenarios::Plan& plan);

/// In the order of the pieces, what was taken out last.
/// bones  that were operated on
std::vector<Body> bodies_of(const RebuiltBone& rebuilt, const scenarios::Plan& plan,
                            const simulator::Bones& bones);

/// A sawn face is sampled so that each point of it has a sample this near.
inline constexpr double sample_reach_mm = 0.5;

/// How a body lies.
struct BodyPlacement {
  /// The way of its centroid, and its turn.
  double moved_mm = 0.0, turned_deg = 0.0;
  /// Against where the plan brings the fragment; nothing of a body that the plan does not move.
  std::optional<double> error_mm, error_deg;
  /// Of the area that was sawn, the part within 0.2 mm of another body; nothing where none was.
  std::optional<double> contact_share;
  /// How far that share may be from the exact one.
  double contact_bound = 0.0;
  /// The widest gap between what was sawn and a body that it faces within 5 mm; nothing where it
  /// faces none.
  std::optional<double> gap_max_mm;
  /// How deep a point of its surface lies in another body; 0: in none.
  double overlap_max_mm = 0.0;
};

/// Of each body. What was taken out meets nothing.
std::vector<BodyPlacement> placements_of(const std::vector<Body>& bodies,
                                         const RebuiltBone& rebuilt, const scenarios::Plan& plan);

}  // namespace hallux::assessment
